// make_plate: writes the models of the plate scene, prints the taps on it, and checks both.

#include <algorithm>
#include <array>
#include <cstdio>
#include <iterator>

#include "tools/content/mesh/maker.h"
#include "tools/content/mesh/mass.h"
#include "tools/content/mesh/solid_check.h"
#include "tools/content/mesh/way_check.h"
#include "tools/content/plate/marks.h"
#include "tools/content/plate/route.h"
#include "tools/content/plate/stand.h"
#include "tools/content/plate/stylus.h"
#include "tools/content/plate/table.h"

namespace fulcrum::content {
namespace {

constexpr double least_clearance = 1.0 * mm;
constexpr double tip_region = 4.0 * mm;  // of the stylus, which may touch what it taps
constexpr double stride = 1.0 * mm;
constexpr double press_depth = 5.0 * mm;

bool check_taps(const TriangleTree& scene, const Model& stylus) {
  std::vector<Eigen::Vector3d> all;
  std::vector<Eigen::Vector3d> behind_tip;
  for (const Part& part : stylus.parts)
    all.insert(all.end(), part.solid.points.begin(), part.solid.points.end());
  std::copy_if(all.begin(), all.end(), std::back_inserter(behind_tip),
               [](const Eigen::Vector3d& p) { return p.norm() > tip_region; });
  const double least = clearance_on_way(make_route(make_taps(), 0.0), scene, all, behind_tip, stride);
  const bool fits = least >= least_clearance;
  std::printf("clearance of the stylus on its way: %.2f mm%s\n", least / mm, fits ? "" : ": TOO LITTLE");
  return fits;
}

bool check() {
  const std::array scene{make_plates(), make_stand()};
  const Model stylus = make_stylus();
  bool good = check_solids(stylus);
  good &= check_solids(make_marks());
  good &= check_solids(make_table());
  for (const Model& model : scene) good &= check_solids(model);
  good &= check_taps(tree_of(scene), stylus);
  return good;
}

}  // namespace
}  // namespace fulcrum::content

int main(int argc, char** argv) {
  using namespace fulcrum::content;
  const auto models = [] {
    return std::vector{make_plates(), make_stand(), make_marks(), make_table(), make_stylus()};
  };
  const auto route = [] {
    return route_yaml("over each place, straight onto it, and off again at once", "make_plate",
                      make_route(make_taps(), press_depth));
  };
  const auto checkpoints = [] { return taps_yaml(make_taps()); };
  return run_maker({"make_plate", models, route, checkpoints, check}, argc, argv);
}
