#include "haptics/bake/surfaces.h"

#include <algorithm>
#include <numeric>

#include "haptics/bake/edge_fans.h"
#include "haptics/bake/weld.h"

namespace fulcrum {
void measure_volume(const TriangleMesh& mesh, SolidComponent& component) {
  component.volume_m3 = 0.0;
  const Vec3 centre = component.bounds.center();
  for (std::uint32_t t = 0; t < component.triangle_count; ++t) {
    const Triangle& corner = mesh.triangles[component.first_triangle + t];
    const Vec3 a = mesh.vertices[corner[0]] - centre, b = mesh.vertices[corner[1]] - centre,
               c = mesh.vertices[corner[2]] - centre;
    component.volume_m3 += a.dot(b.cross(c)) / 6.0;
  }
}

Solid part_surfaces(const TriangleMesh& closed, const std::vector<std::uint32_t>& across) {
  const auto triangle_count = static_cast<std::uint32_t>(closed.triangles.size());
  Sets surfaces(triangle_count), fans(across.size());
  for (std::uint32_t h = 0; h < across.size(); ++h) {
    const std::uint32_t g = across[h];
    surfaces.join(h / 3, g / 3);
    // The half-edge across runs the other way: this one's start is that one's end.
    fans.join(h, g / 3 * 3 + (g % 3 + 1) % 3);
  }

  std::vector<std::uint32_t> order(triangle_count), place(triangle_count);
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t l, std::uint32_t r) { return surfaces.find(l) < surfaces.find(r); });
  for (std::uint32_t i = 0; i < triangle_count; ++i) place[order[i]] = i;

  Solid solid;
  std::vector<std::uint32_t> vertex_of_fan(across.size(), kNoIndex);
  std::uint32_t previous = kNoIndex;
  for (std::uint32_t i = 0; i < triangle_count; ++i) {
    const std::uint32_t t = order[i];
    if (surfaces.find(t) != previous) {
      previous = surfaces.find(t);
      solid.components.emplace_back();
      solid.components.back().first_triangle = i;
    }
    SolidComponent& component = solid.components.back();
    ++component.triangle_count;
    Triangle corner{}, neighbour{};
    for (std::uint32_t e = 0; e < 3; ++e) {
      std::uint32_t& vertex = vertex_of_fan[fans.find(3 * t + e)];
      if (vertex == kNoIndex) {
        vertex = static_cast<std::uint32_t>(solid.mesh.vertices.size());
        solid.mesh.vertices.push_back(closed.vertices[closed.triangles[t][e]]);
      }
      corner[e] = vertex;
      neighbour[e] = place[across[3 * t + e] / 3];
      component.bounds.extend(solid.mesh.vertices[vertex]);
    }
    solid.mesh.triangles.push_back(corner);
    solid.neighbours.push_back(neighbour);
  }
  for (SolidComponent& component : solid.components) measure_volume(solid.mesh, component);
  return solid;
}

TriangleMesh own_triangles(const TriangleMesh& mesh, const SolidComponent& component) {
  TriangleMesh result;
  std::vector<std::uint32_t> renumbered(mesh.vertices.size(), kNoIndex);
  for (std::uint32_t t = component.first_triangle; t < component.first_triangle + component.triangle_count;
       ++t) {
    Triangle corner = mesh.triangles[t];
    for (std::uint32_t& v : corner) {
      if (renumbered[v] == kNoIndex) {
        renumbered[v] = static_cast<std::uint32_t>(result.vertices.size());
        result.vertices.push_back(mesh.vertices[v]);
      }
      v = renumbered[v];
    }
    result.triangles.push_back(corner);
  }
  return result;
}

void regroup(Solid& solid, const std::vector<std::vector<std::uint32_t>>& groups) {
  std::vector<SolidComponent> components;
  std::vector<std::uint32_t> order, place(solid.mesh.triangles.size());
  for (const std::vector<std::uint32_t>& group : groups) {
    if (group.empty()) continue;
    SolidComponent joined = solid.components[group.front()];
    joined.first_triangle = static_cast<std::uint32_t>(order.size());
    joined.volume_m3 = 0.0;
    for (const std::uint32_t k : group) {
      const SolidComponent& part = solid.components[k];
      joined.volume_m3 += part.volume_m3;
      for (std::uint32_t t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t) {
        place[t] = static_cast<std::uint32_t>(order.size());
        order.push_back(t);
      }
    }
    joined.triangle_count = static_cast<std::uint32_t>(order.size()) - joined.first_triangle;
    components.push_back(std::move(joined));
  }
  std::vector<Triangle> triangles, neighbours;
  for (const std::uint32_t t : order) {
    triangles.push_back(solid.mesh.triangles[t]);
    neighbours.push_back(solid.neighbours[t]);
    for (std::uint32_t& there : neighbours.back()) there = place[there];
  }
  solid.components = std::move(components);
  solid.mesh.triangles = std::move(triangles);
  solid.neighbours = std::move(neighbours);
}

}  // namespace fulcrum
