// Surfaces that cross themselves.

#include <algorithm>

#include "haptics/bake/edge_pairing.h"
#include "haptics/bake/outer_boundary.h"
#include "haptics/bake/sentence.h"
#include "haptics/bake/surfaces.h"

namespace fulcrum {
namespace {

constexpr double kGraze = 1e-7;  // of the diagonal: triangles that cross less deeply touch

bool has_sliver(const Solid& solid, const SolidComponent& component) {
  for (std::uint32_t t = component.first_triangle; t < component.first_triangle + component.triangle_count;
       ++t) {
    const auto [a, b, c] = corners_of(solid.mesh, t);
    if (is_sliver(a, b, c)) return true;
  }
  return false;
}

void append(Solid& solid, SolidComponent component, const TriangleMesh& mesh,
            const std::vector<Triangle>& neighbours) {
  const auto first_vertex = static_cast<std::uint32_t>(solid.mesh.vertices.size());
  component.first_triangle = static_cast<std::uint32_t>(solid.mesh.triangles.size());
  component.triangle_count = static_cast<std::uint32_t>(mesh.triangles.size());
  solid.mesh.vertices.insert(solid.mesh.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& corner = mesh.triangles[t];
    solid.mesh.triangles.push_back(
        {corner[0] + first_vertex, corner[1] + first_vertex, corner[2] + first_vertex});
    Triangle neighbour = neighbours[t];
    for (std::uint32_t& there : neighbour)
      if (there != Solid::kNoNeighbour) there += component.first_triangle;
    solid.neighbours.push_back(neighbour);
  }
  solid.components.push_back(std::move(component));
}

std::vector<Triangle> neighbours_of(const TriangleMesh& welded) {
  const std::vector<std::uint32_t> across = pair_edges(welded, EdgeFans(welded.triangles));
  std::vector<Triangle> neighbours(welded.triangles.size());
  for (std::size_t h = 0; h < across.size(); ++h)
    neighbours[h / 3][h % 3] = across[h] == kNoIndex ? Solid::kNoNeighbour : across[h] / 3;
  return neighbours;
}

std::vector<Triangle> neighbours_of(const Solid& solid, const SolidComponent& part) {
  std::vector<Triangle> neighbours(solid.neighbours.begin() + part.first_triangle,
                                   solid.neighbours.begin() + part.first_triangle + part.triangle_count);
  for (Triangle& neighbour : neighbours)
    for (std::uint32_t& there : neighbour) there -= part.first_triangle;
  return neighbours;
}

}  // namespace

void cut_self_crossings(Solid& solid) {
  const TriangleTree tree(solid);
  std::vector<std::optional<std::uint32_t>> crossing;
  bool any = false;
  for (std::uint32_t k = 0; k < solid.components.size(); ++k) {
    SolidComponent& component = solid.components[k];
    crossing.push_back(find_crossing(solid, k, tree, kGraze * component.bounds.diagonal().norm()));
    any = any || crossing.back();
    if (!crossing.back() && has_sliver(solid, component))
      component.shell = own_triangles(solid.mesh, component);
  }
  if (!any) return;

  Solid result;
  result.dropped_triangles = solid.dropped_triangles;
  result.notes = solid.notes;
  for (std::uint32_t k = 0; k < solid.components.size(); ++k) {
    SolidComponent component = solid.components[k];
    const TriangleMesh own = own_triangles(solid.mesh, component);
    if (!crossing[k]) {
      append(result, component, own, neighbours_of(solid, component));
      continue;
    }
    component.shell = own;
    const OuterBoundary outer = outer_boundary(solid, k, tree, Winding(own));
    const Corners3 there = corners_of(solid.mesh, *crossing[k]);
    result.notes.push_back("A surface of " + std::to_string(component.triangle_count) + " triangles around " +
                           spell(component.bounds.center()) + " crosses itself, for one near " +
                           spell(Vec3((there[0] + there[1] + there[2]) / 3.0)) +
                           ": what it winds around at least once is taken as inside.");
    if (outer.inside_out)
      result.notes.push_back("Near " + spell(outer.inside_out_at) +
                             " that surface is inside out, and what it encloses there is taken as outside.");
    if (outer.mesh.triangles.empty()) continue;
    component.bounds = Box3();
    for (const Vec3& p : outer.mesh.vertices) component.bounds.extend(p);
    append(result, component, outer.mesh, neighbours_of(outer.mesh));
    measure_volume(result.mesh, result.components.back());
  }
  solid = std::move(result);
}

}  // namespace fulcrum
