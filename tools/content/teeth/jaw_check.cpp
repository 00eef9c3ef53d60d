#include "tools/content/teeth/jaw_check.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tools/content/mesh/way_check.h"
#include "tools/content/teeth/tooth_table.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector3d;

constexpr double tolerance = 0.3;             // mm, of sizes
constexpr double widest_gap = 0.0;            // mm, between neighbours
constexpr double deepest_overlap = 0.15;      // mm
constexpr double least_clearance = 0.3 * mm;  // of the explorer on its way
constexpr double tip_region = 1.5 * mm;  // of the explorer, which may come near to what it is let down to
constexpr double stride = 1.0 * mm;      // of any of its points, along the way

ToothSize measured(const Tooth& tooth, const Solid& solid) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& p : solid.points) box.extend(tooth.to_tooth(p / mm));
  const CrownBody& body = tooth.design.body;
  const Vector3d sizes = tooth.size * box.sizes();
  return {.kind = tooth_table[static_cast<std::size_t>(tooth.number % 10 - 1)].kind,
          .crown_length = tooth.size * box.max().z(),
          .width = sizes.x(),
          .depth = sizes.y(),
          .cervix_width = tooth.size * (body.mesial(0.0) + body.distal(0.0)),
          .cervix_depth = tooth.size * (body.buccal(0.0) + body.lingual(0.0))};
}

bool alike(const ToothSize& a, const ToothSize& b) {
  const auto near = [](double u, double v) { return std::abs(u - v) <= tolerance; };
  return near(a.crown_length, b.crown_length) && near(a.width, b.width) && near(a.depth, b.depth) &&
         near(a.cervix_width, b.cervix_width) && near(a.cervix_depth, b.cervix_depth);
}

}  // namespace

bool check_sizes(const Dentition& dentition, const Model& jaw) {
  bool good = true;
  int count = 0;
  for (const Part& part : jaw.parts) {
    if (!part.name.starts_with("tooth/")) continue;
    ++count;
    const Tooth& tooth = dentition.tooth(std::stoi(part.name.substr(6)));
    const ToothSize& wanted = tooth_table[static_cast<std::size_t>(tooth.number % 10 - 1)];
    const ToothSize m = measured(tooth, part.solid);
    const bool fits = alike(m, wanted);
    std::printf("%d, %s: crown %.2f (%.1f), width %.2f (%.1f), depth %.2f (%.1f) mm%s\n", tooth.number,
                m.kind, m.crown_length, wanted.crown_length, m.width, wanted.width, m.depth, wanted.depth,
                fits ? "" : ": NOT AS THE TABLE HAS IT");
    good &= fits;
  }
  std::printf("teeth: %d%s\n", count, count == 14 ? "" : ", NOT 14");
  return good && count == 14;
}

bool check_contacts(const Dentition& dentition) {
  bool good = true;
  for (std::size_t i = 0; i + 1 < dentition.teeth.size(); ++i) {
    const double depth = contact_depth(dentition.teeth[i], dentition.teeth[i + 1]);
    const bool fits = depth >= -widest_gap && depth <= deepest_overlap;
    std::printf("contact of %d and %d: %.3f mm deep%s\n", dentition.teeth[i].number,
                dentition.teeth[i + 1].number, depth, fits ? "" : ": NOT A CONTACT");
    good &= fits;
  }
  return good;
}

bool check_way(const std::vector<RoutePose>& route, const TriangleTree& scene, const Model& explorer) {
  const std::vector<Vector3d>& all = explorer.parts.front().solid.points;
  std::vector<Vector3d> behind_tip;
  std::copy_if(all.begin(), all.end(), std::back_inserter(behind_tip),
               [](const Vector3d& p) { return p.norm() > tip_region; });
  const double least = clearance_on_way(route, scene, all, behind_tip, stride);
  const bool fits = least >= least_clearance;
  std::printf("clearance of the explorer on its way: %.2f mm%s\n", least / mm, fits ? "" : ": TOO LITTLE");
  return fits;
}

}  // namespace fulcrum::content
