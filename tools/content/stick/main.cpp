// make_stick: writes the models of the stick scene, prints the touches in it, and checks both.

#include <algorithm>
#include <array>
#include <cstdio>
#include <iterator>

#include "tools/content/mesh/maker.h"
#include "tools/content/mesh/solid_check.h"
#include "tools/content/mesh/way_check.h"
#include "tools/content/stick/ball.h"
#include "tools/content/stick/route.h"
#include "tools/content/stick/stick.h"

namespace fulcrum::content {
namespace {

constexpr double press_depth = 9.0 * mm;  // a hand of 400 N/m gets to 5 mm against 300 N/m
constexpr double stride = 1.0 * mm;
constexpr double least_clearance = 5.0 * mm;

// The stage stays clear of ball and stand, however deep the stick goes.
bool check_way() {
  const std::array scene{make_ball(), make_stand()};
  std::vector<Eigen::Vector3d> stage;
  for (const Part& part : make_stick().parts) {
    std::copy_if(
        part.solid.points.begin(), part.solid.points.end(), std::back_inserter(stage),
        [](const Eigen::Vector3d& p) { return p.x() < 25.0 * mm; });
  }
  const double least = clearance_on_way(make_route(press_depth), tree_of(scene), stage, stage, stride);
  const bool fits = least >= least_clearance;
  std::printf("clearance of the stage: %.2f mm or more%s\n", least / mm, fits ? "" : ": TOO LITTLE");
  return fits;
}

bool check() {
  bool good = true;
  for (const Model& model : {make_ball(), make_stand(), make_table(), make_stick()})
    good &= check_solids(model);
  return good && check_way();
}

}  // namespace
}  // namespace fulcrum::content

int main(int argc, char** argv) {
  using namespace fulcrum::content;
  const auto models = [] { return std::vector{make_ball(), make_stand(), make_table(), make_stick()}; };
  const auto route = [] {
    return route_yaml("the ball touched at three places of the stick, and the hand moved along it meanwhile",
                      "make_stick", make_route(press_depth));
  };
  return run_maker({"make_stick", models, route, touches_yaml, check}, argc, argv);
}
