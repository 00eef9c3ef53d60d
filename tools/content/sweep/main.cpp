// make_sweep: writes the models of the sweep scene, prints the sweeps in it, and checks both.

#include <array>
#include <cstdio>

#include "tools/content/mesh/maker.h"
#include "tools/content/mesh/solid_check.h"
#include "tools/content/mesh/way_check.h"
#include "tools/content/sweep/finger.h"
#include "tools/content/sweep/route.h"
#include "tools/content/sweep/tablet.h"

namespace fulcrum::content {
namespace {

constexpr double press_depth = 2.5 * mm;
constexpr double stride = 1.0 * mm;
constexpr double least_clearance = 1.5 * mm;

// What is worn stays off the glass while the pad is on it.
bool check_way() {
  const std::array scene{make_tablet()};
  std::vector<Eigen::Vector3d> worn;
  for (const Part& part : make_finger().parts) {
    if (part.name == "skin" || part.name == "nail") continue;
    worn.insert(worn.end(), part.solid.points.begin(), part.solid.points.end());
  }
  const double least = clearance_on_way(make_route(0.0), tree_of(scene), worn, worn, stride);
  const bool fits = least >= least_clearance;
  std::printf("clearance of what is worn: %.2f mm%s\n", least / mm, fits ? "" : ": TOO LITTLE");
  return fits;
}

bool check() {
  bool good = true;
  for (const Model& model : {make_tablet(), make_window_marks(), make_desk(), make_finger()})
    good &= check_solids(model);
  return check_way() && good;
}

}  // namespace
}  // namespace fulcrum::content

int main(int argc, char** argv) {
  using namespace fulcrum::content;
  const auto models = [] {
    return std::vector{make_tablet(), make_window_marks(), make_desk(), make_finger()};
  };
  const auto route = [] {
    return route_yaml("to the right and to the left over the window, beside the target", "make_sweep",
                      make_route(press_depth));
  };
  return run_maker({"make_sweep", models, route, sweeps_yaml, check}, argc, argv);
}
