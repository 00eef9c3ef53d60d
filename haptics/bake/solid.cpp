#include "haptics/bake/solid.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <unordered_map>

#include "haptics/bake/edge_pairing.h"
#include "haptics/bake/sentence.h"

namespace fulcrum {
namespace {

constexpr std::uint32_t kNone = EdgePairing::kNone;
constexpr double kFlat = 1e-12;  // volume over the cube of the diagonal: below it is rounding

struct PositionHash {
  std::size_t operator()(const std::array<double, 3>& p) const {
    std::size_t hash = 0;
    for (const double x : p) hash = (hash ^ std::hash<double>()(x)) * 0x9e3779b97f4a7c15ull;
    return hash ^ (hash >> 32);
  }
};

std::optional<Error> check_numbers(const TriangleMesh& soup) {
  if (soup.triangles.empty()) {
    return Error{"The mesh has no triangles: check that the file holds a surface, not only lines or points."};
  }
  if (soup.vertices.size() >= kNone / 8 || soup.triangles.size() >= kNone / 24) {
    return Error{"The mesh has " + std::to_string(soup.triangles.size()) +
                 " triangles, more than can be indexed: simplify it before export."};
  }
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    for (const std::uint32_t v : soup.triangles[t]) {
      if (v >= soup.vertices.size()) {
        return Error{"Triangle " + std::to_string(t) + " refers to vertex " + std::to_string(v) + " of " +
                     std::to_string(soup.vertices.size()) + ": the mesh is damaged; export it again."};
      }
      if (!soup.vertices[v].allFinite()) {
        return Error{"Vertex " + std::to_string(v) +
                     " of the mesh is not a finite number: the mesh is damaged; export it again."};
      }
    }
  }
  return std::nullopt;
}

// Vertices at equal positions become one; triangles with two corners in one place are left out.
TriangleMesh weld(const TriangleMesh& soup, std::uint32_t& dropped) {
  TriangleMesh welded;
  std::unordered_map<std::array<double, 3>, std::uint32_t, PositionHash> known;
  known.reserve(soup.vertices.size());
  std::vector<std::uint32_t> renumbered(soup.vertices.size(), kNone);
  for (const Triangle& triangle : soup.triangles) {
    Triangle corner{};
    for (std::size_t i = 0; i < 3; ++i) {
      std::uint32_t& vertex = renumbered[triangle[i]];
      if (vertex == kNone) {
        const Vec3 p = soup.vertices[triangle[i]] + Vec3::Zero();  // -0 becomes 0
        const auto next = static_cast<std::uint32_t>(welded.vertices.size());
        const auto [entry, is_new] = known.try_emplace({p.x(), p.y(), p.z()}, next);
        if (is_new) welded.vertices.push_back(p);
        vertex = entry->second;
      }
      corner[i] = vertex;
    }
    if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0]) {
      ++dropped;
    } else {
      welded.triangles.push_back(corner);
    }
  }
  return welded;
}

std::string count_edges(const EdgePairing::Fault& fault) {
  return std::to_string(fault.edges) + (fault.edges == 1 ? " edge" : " edges");
}

Error describe(const EdgePairing& pairing) {
  std::string found;
  const EdgePairing::Fault* shown = nullptr;
  const auto add = [&](const EdgePairing::Fault& fault, const char* what) {
    if (fault.edges == 0) return;
    found += (found.empty() ? "" : ", ") + count_edges(fault) + what;
    if (shown == nullptr) shown = &fault;
  };
  add(pairing.open, " with one triangle only (holes)");
  add(pairing.tangled, " with three or more triangles that cannot be paired (non-manifold)");
  add(pairing.twisted, " whose triangles are wound against each other");
  std::string remedy;
  if (pairing.open.edges > 0) remedy += " Fill the holes (vertices that should meet must agree exactly).";
  if (pairing.tangled.edges > 0) remedy += " Make the surface manifold, each body closed by itself.";
  if (pairing.twisted.edges > 0) remedy += " Recalculate the normals to point outside.";
  return {"The mesh does not bound a solid: " + found + "; one runs from " + spell(shown->from) + " to " +
          spell(shown->to) + "." + remedy};
}

// Disjoint sets of numbers; the lowest of each stands for it.
class Sets {
public:
  explicit Sets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0u); }
  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t i, std::uint32_t j) {
    i = find(i);
    j = find(j);
    parent_[std::max(i, j)] = std::min(i, j);
  }

private:
  std::vector<std::uint32_t> parent_;
};

// Triangles component by component; each fan of triangles about a vertex gets a vertex of its own.
Solid assemble(const TriangleMesh& welded, const std::vector<std::uint32_t>& across) {
  const auto triangle_count = static_cast<std::uint32_t>(welded.triangles.size());
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
  std::vector<std::uint32_t> vertex_of_fan(across.size(), kNone);
  std::uint32_t previous = kNone;
  for (std::uint32_t i = 0; i < triangle_count; ++i) {
    const std::uint32_t t = order[i];
    if (surfaces.find(t) != previous) {
      previous = surfaces.find(t);
      solid.components.push_back({i, 0, Box3(), 0.0});
    }
    SolidComponent& component = solid.components.back();
    ++component.triangle_count;
    Triangle corner{}, neighbour{};
    for (std::uint32_t e = 0; e < 3; ++e) {
      std::uint32_t& vertex = vertex_of_fan[fans.find(3 * t + e)];
      if (vertex == kNone) {
        vertex = static_cast<std::uint32_t>(solid.mesh.vertices.size());
        solid.mesh.vertices.push_back(welded.vertices[welded.triangles[t][e]]);
      }
      corner[e] = vertex;
      neighbour[e] = place[across[3 * t + e] / 3];
      component.bounds.extend(solid.mesh.vertices[vertex]);
    }
    solid.mesh.triangles.push_back(corner);
    solid.neighbours.push_back(neighbour);
  }
  return solid;
}

std::optional<Error> measure_volumes(Solid& solid) {
  for (SolidComponent& component : solid.components) {
    const Vec3 centre = component.bounds.center();
    for (std::uint32_t t = 0; t < component.triangle_count; ++t) {
      const Triangle& corner = solid.mesh.triangles[component.first_triangle + t];
      const Vec3 a = solid.mesh.vertices[corner[0]] - centre, b = solid.mesh.vertices[corner[1]] - centre,
                 c = solid.mesh.vertices[corner[2]] - centre;
      component.volume_m3 += a.dot(b.cross(c)) / 6.0;
    }
    const double diagonal = component.bounds.diagonal().norm();
    const double flat = kFlat * diagonal * diagonal * diagonal;
    if (component.volume_m3 > flat) continue;
    const std::string where = "A closed surface of " + std::to_string(component.triangle_count) +
                              " triangles around " + spell(centre);
    if (component.volume_m3 < -flat) {
      return Error{where +
                   " is wound inside out: recalculate its normals to point outside; if it is meant as a "
                   "cavity, connect it to the surface around it."};
    }
    return Error{where + " has no volume: remove it, or give it thickness."};
  }
  return std::nullopt;
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
  const TriangleMesh welded = weld(soup, dropped);
  if (welded.triangles.empty()) {
    return Error{
        "All " + std::to_string(dropped) +
        " triangles of the mesh have two corners in one place: check its scale and export it again."};
  }
  const EdgePairing pairing = pair_edges(welded);
  if (!pairing.complete()) return describe(pairing);
  Solid solid = assemble(welded, pairing.across);
  solid.dropped_triangles = dropped;
  if (std::optional<Error> error = measure_volumes(solid)) return *error;
  return solid;
}

}  // namespace fulcrum
