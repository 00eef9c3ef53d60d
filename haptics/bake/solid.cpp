#include "haptics/bake/solid.h"

#include <algorithm>
#include <optional>
#include <string>

#include "haptics/bake/edge_pairing.h"
#include "haptics/bake/repair.h"
#include "haptics/bake/sentence.h"
#include "haptics/bake/surfaces.h"
#include "haptics/bake/weld.h"

namespace fulcrum {
namespace {

constexpr double kFlat = 1e-12;  // volume over the cube of the diagonal: below it is rounding

// The bodies that do not close are repaired, each other one stays as it is. Answers the notes.
Result<std::vector<std::string>> repair_bodies(TriangleMesh& welded, const EdgeFans& fans,
                                               const std::vector<std::uint32_t>& across) {
  Sets bodies(welded.triangles.size());
  fans.for_each([&bodies](std::span<const HalfEdge> fan) {
    for (const HalfEdge& edge : fan) bodies.join(fan[0].place / 3, edge.place / 3);
  });
  std::vector<bool> faulty(welded.triangles.size());  // by the number that stands for the body
  for (std::uint32_t h = 0; h < across.size(); ++h)
    if (across[h] == kNoIndex) faulty[bodies.find(h / 3)] = true;
  TriangleMesh broken{welded.vertices, {}};
  std::vector<Triangle> whole;
  for (std::uint32_t t = 0; t < welded.triangles.size(); ++t)
    (faulty[bodies.find(t)] ? broken.triangles : whole).push_back(welded.triangles[t]);
  Result<Repaired> repaired = repair_mesh(std::move(broken));
  if (!repaired) return repaired.error();
  whole.insert(whole.end(), repaired->mesh.triangles.begin(), repaired->mesh.triangles.end());
  welded.triangles = std::move(whole);
  return std::move(repaired->notes);
}

double area_of(const Solid& solid, const SolidComponent& component) {
  double area = 0.0;
  for (std::uint32_t t = component.first_triangle; t < component.first_triangle + component.triangle_count;
       ++t) {
    const Triangle& corner = solid.mesh.triangles[t];
    const Vec3& a = solid.mesh.vertices[corner[0]];
    area += 0.5 * (solid.mesh.vertices[corner[1]] - a).cross(solid.mesh.vertices[corner[2]] - a).norm();
  }
  return area;
}

bool is_flat(const SolidComponent& component) {
  const double diagonal = component.bounds.diagonal().norm();
  return std::abs(component.volume_m3) <= kFlat * diagonal * diagonal * diagonal;
}

// Mending leaves scraps where single triangles hung in a hole; anything else that is flat was meant.
std::optional<Error> drop_flat(Solid& solid, bool is_mended) {
  std::vector<std::vector<std::uint32_t>> groups;
  double whole = 0.0;
  for (const SolidComponent& component : solid.components) whole += area_of(solid, component);
  std::size_t scraps = 0;
  for (std::uint32_t k = 0; k < solid.components.size(); ++k) {
    const SolidComponent& component = solid.components[k];
    if (!is_flat(component)) {
      groups.push_back({k});
    } else if (is_mended && area_of(solid, component) <= kScrap * whole) {
      ++scraps;
    } else {
      return Error{"A closed surface of " + std::to_string(component.triangle_count) + " triangles around " +
                   spell(component.bounds.center()) + " has no volume: remove it, or give it thickness."};
    }
  }
  if (scraps > 0) {
    solid.notes.push_back(count(scraps, "scrap", "scraps") + " without volume left out.");
    regroup(solid, groups);
  }
  return std::nullopt;
}

Error nothing_bounded() {
  return {"No part of the mesh bounds a solid: model closed bodies, with a thickness."};
}

}  // namespace

Box3 Solid::bounds() const {
  Box3 box;
  for (const SolidComponent& component : components) box.extend(component.bounds);
  return box;
}

Result<Solid> build_solid(const TriangleMesh& soup) {
  if (std::optional<Error> error = check_numbers(soup)) return *error;
  std::uint32_t dropped = 0;
  TriangleMesh welded = weld(soup, dropped);
  if (welded.triangles.empty()) {
    return Error{
        "All " + std::to_string(dropped) +
        " triangles of the mesh have two corners in one place: check its scale and export it again."};
  }
  std::vector<std::string> notes;
  bool is_mended = false;
  std::optional<EdgeFans> fans(welded.triangles);
  std::vector<std::uint32_t> across = pair_edges(welded, *fans);
  if (std::find(across.begin(), across.end(), kNoIndex) != across.end()) {
    Result<std::vector<std::string>> repaired = repair_bodies(welded, *fans, across);
    if (!repaired) return repaired.error();
    notes = std::move(*repaired);
    is_mended = true;
    fans.emplace(welded.triangles);
    across = pair_edges(welded, *fans);
  }
  Solid solid = part_surfaces(welded, across);
  solid.dropped_triangles = dropped;
  solid.notes = std::move(notes);
  if (std::optional<Error> error = drop_flat(solid, is_mended)) return *error;
  if (solid.components.empty()) return nothing_bounded();
  assign_cavities(solid);
  cut_self_crossings(solid);
  if (solid.components.empty()) return nothing_bounded();
  return solid;
}

}  // namespace fulcrum
