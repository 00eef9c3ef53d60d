// make_piping: writes the models of the piping scene, prints the route through it and the way of a hand that
// turns the spanner wrongly, and checks models and route.

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <span>
#include <string>
#include <vector>

#include "tools/content/mesh/glb_writer.h"
#include "tools/content/mesh/mass.h"
#include "tools/content/mesh/solid_check.h"
#include "tools/content/piping/piping.h"
#include "tools/content/piping/route.h"
#include "tools/content/piping/route_check.h"
#include "tools/content/piping/spanner.h"
#include "tools/content/piping/wrong_turns.h"

namespace fulcrum::content {
namespace {

constexpr double least_clearance = 0.8 * mm;
constexpr double least_clearance_elsewhere = 15.0 * mm;  // from all but the slot's pipes and the target bolt
constexpr double least_line_gap = 4.0 * mm;

void print_spanner(const Model& spanner) {
  const MassProperties m = mass_properties(spanner.parts.front().solid, steel_density);
  const Eigen::Vector3d drawn = spanner_centre_of_mass();
  std::printf("mass_kg: %.6f\n", m.mass);
  std::printf("centre_of_mass_m: [%.3e, %.3e, %.3e]\n", m.centre.x(), m.centre.y(), m.centre.z());
  std::printf("centre_of_mass_in_drawing_m: [%.6f, %.6f, %.6f]\n", drawn.x(), drawn.y(), drawn.z());
  std::printf("inertia_kg_m2:\n");
  for (int row = 0; row < 3; ++row)
    std::printf("  - [%.6e, %.6e, %.6e]\n", m.inertia(row, 0), m.inertia(row, 1), m.inertia(row, 2));
}

bool check_clearance(const Model& piping, const Model& spanner, Near near, const char* from, double least) {
  const std::vector<Clearance> all = clearances(piping, spanner, near);
  const auto nearest = std::min_element(
      all.begin(), all.end(), [](const Clearance& a, const Clearance& b) { return a.distance < b.distance; });
  const bool enough = nearest->distance >= least;
  const std::vector<PlantPose> poses = route();
  std::string after = "start";
  for (std::size_t i = 0; i <= nearest->route_index; ++i)
    if (!poses[i].name.empty()) after = poses[i].name;
  std::printf(
      "clearance from %s: %.2f mm at (%.1f, %.1f, %.1f) mm, %.0f %% of the way on from pose %zu (after "
      "'%s')%s\n",
      from, nearest->distance / mm, nearest->p_W.x() / mm, nearest->p_W.y() / mm, nearest->p_W.z() / mm,
      100.0 * nearest->route_part, nearest->route_index, after.c_str(), enough ? "" : ": TOO LITTLE");
  return enough;
}

int check() {
  const Model piping = make_piping();
  const Model spanner = make_spanner();
  bool good = check_solids(piping);
  good &= check_solids(spanner);
  const LineGap gap = narrowest_line_gap(piping);
  std::printf("narrowest gap between lines: %.2f mm, %s and %s%s\n", gap.distance / mm, gap.first.c_str(),
              gap.second.c_str(), gap.distance >= least_line_gap ? "" : ": TOO LITTLE");
  good &= gap.distance >= least_line_gap;
  good &= check_clearance(piping, spanner, Near::slot_pipes, "the slot's pipes", least_clearance);
  good &= check_clearance(piping, spanner, Near::target_bolt, "the target bolt", least_clearance);
  good &=
      check_clearance(piping, spanner, Near::everything_else, "everything else", least_clearance_elsewhere);
  return good ? 0 : 1;
}

int run(std::span<char*> arguments) {
  const std::string what = arguments.size() == 2 ? arguments[1] : "";
  if (what == "--route") {
    std::cout << route_yaml();
    return 0;
  }
  if (what == "--wrong-turns") {
    std::cout << wrong_turns_yaml();
    return 0;
  }
  if (what == "--check") return check();
  if (what.empty() || what.starts_with("-")) {
    std::cerr << "usage: make_piping OUTDIR | --route | --wrong-turns | --check\n";
    return 2;
  }
  const Model spanner = make_spanner();
  if (!write_models({make_piping(), spanner}, what, "make_piping")) return 1;
  print_spanner(spanner);
  return 0;
}

}  // namespace
}  // namespace fulcrum::content

int main(int argc, char** argv) {
  return fulcrum::content::run(std::span(argv, static_cast<std::size_t>(argc)));
}
