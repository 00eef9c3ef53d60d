#include "haptics/bake/solid.h"

#include <algorithm>
#include <optional>
#include <string>

#include "haptics/bake/edge_pairing.h"
#include "haptics/bake/repair.h"
#include "haptics/bake/sentence.h"
#include "haptics/bake/surfaces.h"
#include "haptics/bake/t_junctions.h"
#include "haptics/bake/weld.h"

namespace fulcrum {
namespace {

constexpr double kFlat = 1e-12;  // volume over the cube of the diagonal: below it is rounding

Box3 box_of(const TriangleMesh& mesh) {
  Box3 box;
  for (const Vec3& p : mesh.vertices) box.extend(p);
  return box;
}

bool is_flat(double volume_m3, const Box3& bounds) {
  const double diagonal = bounds.diagonal().norm();
  return std::abs(volume_m3) <= kFlat * diagonal * diagonal * diagonal;
}

// (triangles) which have no height, or no triangle across one of their edges.
std::vector<bool> faulty_triangles(const TriangleMesh& welded, const std::vector<std::uint32_t>& across) {
  const double height = kWithoutHeight * box_of(welded).diagonal().norm();
  std::vector<bool> faulty(welded.triangles.size());
  for (std::uint32_t t = 0; t < faulty.size(); ++t)
    faulty[t] = across[3 * t] == kNoIndex || across[3 * t + 1] == kNoIndex || across[3 * t + 2] == kNoIndex ||
                least_height(welded, welded.triangles[t]) <= height;
  return faulty;
}

// (triangles) m^3, at the number that stands for a body: what it bounds.
std::vector<double> volumes_of(const TriangleMesh& welded, Sets& bodies) {
  std::vector<double> volumes(welded.triangles.size());
  for (std::uint32_t t = 0; t < welded.triangles.size(); ++t) {
    const std::uint32_t body = bodies.find(t);
    const Vec3& origin = welded.vertices[welded.triangles[body][0]];
    const auto corner = [&](std::size_t i) { return Vec3(welded.vertices[welded.triangles[t][i]] - origin); };
    volumes[body] += corner(0).dot(corner(1).cross(corner(2))) / 6;
  }
  return volumes;
}

// The bodies that have faulty triangles are repaired, and those that bound nothing, which may be what hangs
// in a hole of theirs; each other one stays as it is. Answers the notes.
Result<std::vector<std::string>> repair_bodies(TriangleMesh& welded, const EdgeFans& fans,
                                               const std::vector<bool>& faulty_triangle) {
  Sets bodies(welded.triangles.size());
  fans.for_each([&bodies](std::span<const HalfEdge> fan) {
    for (const HalfEdge& edge : fan) bodies.join(fan[0].place / 3, edge.place / 3);
  });
  std::vector<bool> faulty(welded.triangles.size());  // by the number that stands for the body
  const Box3 box = box_of(welded);
  const std::vector<double> volumes = volumes_of(welded, bodies);
  for (std::uint32_t t = 0; t < faulty_triangle.size(); ++t) {
    const std::uint32_t body = bodies.find(t);
    if (faulty_triangle[t] || is_flat(volumes[body], box)) faulty[body] = true;
  }
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

// Mending leaves scraps where single triangles hung in a hole; anything else that is flat was meant.
std::optional<Error> drop_flat(Solid& solid, bool is_mended) {
  std::vector<std::vector<std::uint32_t>> groups;
  double whole = 0.0;
  for (const SolidComponent& component : solid.components) whole += area_of(solid, component);
  std::size_t scraps = 0;
  for (std::uint32_t k = 0; k < solid.components.size(); ++k) {
    const SolidComponent& component = solid.components[k];
    if (!is_flat(component.volume_m3, component.bounds)) {
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
  const std::vector<bool> faulty = faulty_triangles(welded, across);
  if (std::find(faulty.begin(), faulty.end(), true) != faulty.end()) {
    Result<std::vector<std::string>> repaired = repair_bodies(welded, *fans, faulty);
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
