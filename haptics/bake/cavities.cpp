// Surfaces that are inside out: a cavity, or a body that somebody turned.

#include <algorithm>
#include <memory>

#include "haptics/bake/sentence.h"
#include "haptics/bake/surfaces.h"
#include "haptics/bake/winding.h"

namespace fulcrum {
namespace {

bool holds(const Solid& solid, const SolidComponent& outer, const Winding& winding,
           const SolidComponent& inner) {
  if (!outer.bounds.contains(inner.bounds)) return false;
  for (std::uint32_t t = inner.first_triangle; t < inner.first_triangle + inner.triangle_count; ++t) {
    for (const std::uint32_t v : solid.mesh.triangles[t])
      if (winding.around(solid.mesh.vertices[v]) < 1) return false;
  }
  return true;
}

// The smallest component around each one that is inside out; itself, where nothing is around it.
std::vector<std::uint32_t> hosts_of(const Solid& solid) {
  std::vector<std::unique_ptr<Winding>> windings(solid.components.size());
  std::vector<std::uint32_t> hosts;
  for (std::uint32_t k = 0; k < solid.components.size(); ++k) {
    hosts.push_back(k);
    if (solid.components[k].volume_m3 > 0.0) continue;
    for (std::uint32_t o = 0; o < solid.components.size(); ++o) {
      const SolidComponent& outer = solid.components[o];
      if (outer.volume_m3 <= 0.0 || !outer.bounds.contains(solid.components[k].bounds)) continue;
      if (hosts[k] != k && solid.components[hosts[k]].volume_m3 <= outer.volume_m3) continue;
      if (!windings[o]) windings[o] = std::make_unique<Winding>(own_triangles(solid.mesh, outer));
      if (holds(solid, outer, *windings[o], solid.components[k])) hosts[k] = o;
    }
  }
  return hosts;
}

void turn_component(Solid& solid, SolidComponent& component) {
  for (std::uint32_t t = component.first_triangle; t < component.first_triangle + component.triangle_count;
       ++t) {
    std::swap(solid.mesh.triangles[t][1], solid.mesh.triangles[t][2]);
    std::swap(solid.neighbours[t][0], solid.neighbours[t][2]);
  }
  component.volume_m3 = -component.volume_m3;
  solid.notes.push_back("A closed surface of " + std::to_string(component.triangle_count) +
                        " triangles around " + spell(component.bounds.center()) +
                        " was wound inside out and has been turned.");
}

}  // namespace

void assign_cavities(Solid& solid) {
  const std::vector<std::uint32_t> hosts = hosts_of(solid);
  std::vector<std::vector<std::uint32_t>> groups(hosts.size());
  for (std::uint32_t k = 0; k < hosts.size(); ++k) {
    if (hosts[k] == k && solid.components[k].volume_m3 < 0.0) turn_component(solid, solid.components[k]);
    if (hosts[k] == k) groups[k].insert(groups[k].begin(), k);
    if (hosts[k] != k) groups[hosts[k]].push_back(k);
  }
  regroup(solid, groups);
}

}  // namespace fulcrum
