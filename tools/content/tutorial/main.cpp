// make_tutorial: writes the models of the tutorial, prints its lessons and the way through them, and checks
// both.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iterator>

#include "tools/content/mesh/maker.h"
#include "tools/content/mesh/solid_check.h"
#include "tools/content/mesh/way_check.h"
#include "tools/content/tutorial/blade.h"
#include "tools/content/tutorial/places.h"
#include "tools/content/tutorial/room.h"
#include "tools/content/tutorial/route.h"
#include "tools/content/tutorial/stations.h"

namespace fulcrum::content {
namespace {

constexpr double least_clearance = 1.0 * mm;
constexpr double tip_region = 16.0 * mm;  // of the blade, which may touch what is to be touched
constexpr double stride = 1.0 * mm;
constexpr double press_depth = 4.0 * mm;

std::vector<Eigen::Vector3d> points_of(const Model& model) {
  std::vector<Eigen::Vector3d> all;
  for (const Part& part : model.parts)
    all.insert(all.end(), part.solid.points.begin(), part.solid.points.end());
  return all;
}

bool check_way(const TriangleTree& scene, const std::vector<Eigen::Vector3d>& blade) {
  std::vector<Eigen::Vector3d> behind_tip;
  std::copy_if(blade.begin(), blade.end(), std::back_inserter(behind_tip),
               [](const Eigen::Vector3d& p) { return p.norm() > tip_region; });
  const double least = clearance_on_way(make_route(0.0), scene, blade, behind_tip, stride);
  const bool fits = least >= least_clearance;
  std::printf("clearance of the blade on its way: %.2f mm%s\n", least / mm, fits ? "" : ": TOO LITTLE");
  return fits;
}

// Whoever does not turn the blade gets it nowhere near the slot's checkpoint.
bool check_slot() {
  const double in_slot =
      blade_half_width - std::sqrt(blade_half_width * blade_half_width - slot_half_height * slot_half_height);
  const Lesson slot = make_lessons()[1];
  const double needed = slot_depth - (slot.p_P.z() + slot.radius);
  const bool holds = in_slot + 1.0 * mm < needed;
  std::printf("unturned, the blade goes %.2f mm into the slot, and %.2f mm would count%s\n", in_slot / mm,
              needed / mm, holds ? "" : ": TOO FAR");
  return holds;
}

bool check() {
  const std::array scene{make_stations()};
  const Model blade = make_blade();
  bool good = check_solids(blade);
  for (const Model& model : {make_bench(), make_numbers(), scene.front()}) good &= check_solids(model);
  good &= check_way(tree_of(scene), points_of(blade));
  good &= check_slot();
  return good;
}

}  // namespace
}  // namespace fulcrum::content

int main(int argc, char** argv) {
  using namespace fulcrum::content;
  const auto models = [] { return std::vector{make_stations(), make_bench(), make_numbers(), make_blade()}; };
  const auto route = [] {
    return route_yaml("into the hoop, turned and into the slot, onto the pad, down the ridges, and a stop",
                      "make_tutorial", make_route(press_depth));
  };
  const auto checkpoints = [] { return lessons_yaml(make_lessons()); };
  return run_maker({"make_tutorial", models, route, checkpoints, check}, argc, argv);
}
