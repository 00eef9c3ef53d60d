#include "haptics/bake/weld.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <unordered_map>

#include "haptics/bake/edge_fans.h"

namespace fulcrum {
namespace {

struct PositionHash {
  std::size_t operator()(const std::array<double, 3>& p) const {
    std::size_t hash = 0;
    for (const double x : p) hash = (hash ^ std::hash<double>()(x)) * 0x9e3779b97f4a7c15ull;
    return hash ^ (hash >> 32);
  }
};

bool collapsed(const Triangle& corner) {
  return corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0];
}

}  // namespace

std::optional<Error> check_numbers(const TriangleMesh& soup) {
  if (soup.triangles.empty())
    return Error{"The mesh has no triangles: check that the file holds a surface, not only lines or points."};
  if (soup.vertices.size() >= kNoIndex / 8 || soup.triangles.size() >= kNoIndex / 24) {
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

TriangleMesh weld(const TriangleMesh& soup, std::uint32_t& dropped) {
  TriangleMesh welded;
  std::unordered_map<std::array<double, 3>, std::uint32_t, PositionHash> known;
  known.reserve(soup.vertices.size());
  std::vector<std::uint32_t> renumbered(soup.vertices.size(), kNoIndex);
  for (const Triangle& triangle : soup.triangles) {
    Triangle corner{};
    for (std::size_t i = 0; i < 3; ++i) {
      std::uint32_t& vertex = renumbered[triangle[i]];
      if (vertex == kNoIndex) {
        const Vec3 p = soup.vertices[triangle[i]] + Vec3::Zero();  // -0 becomes 0
        const auto next = static_cast<std::uint32_t>(welded.vertices.size());
        const auto [entry, is_new] = known.try_emplace({p.x(), p.y(), p.z()}, next);
        if (is_new) welded.vertices.push_back(p);
        vertex = entry->second;
      }
      corner[i] = vertex;
    }
    if (collapsed(corner))
      ++dropped;
    else
      welded.triangles.push_back(corner);
  }
  return welded;
}

std::vector<bool> repeated_triangles(const TriangleMesh& welded) {
  std::vector<std::pair<Triangle, std::uint32_t>> by_corners;
  for (std::uint32_t t = 0; t < welded.triangles.size(); ++t) {
    Triangle corners = welded.triangles[t];
    std::sort(corners.begin(), corners.end());
    by_corners.emplace_back(corners, t);
  }
  std::sort(by_corners.begin(), by_corners.end());
  std::vector<bool> repeated(welded.triangles.size());
  for (std::size_t i = 1; i < by_corners.size(); ++i)
    repeated[by_corners[i].second] = by_corners[i].first == by_corners[i - 1].first;
  return repeated;
}

Mended close_cracks(TriangleMesh& mesh, double width_m) {
  std::vector<std::uint32_t> open;  // vertices, by rising x
  EdgeFans(mesh.triangles).for_each([&open](std::span<const HalfEdge> fan) {
    if (fan.size() != 1) return;
    open.push_back(fan.front().low);
    open.push_back(fan.front().high);
  });
  std::sort(open.begin(), open.end());
  open.erase(std::unique(open.begin(), open.end()), open.end());
  std::stable_sort(open.begin(), open.end(), [&](std::uint32_t l, std::uint32_t r) {
    return mesh.vertices[l].x() < mesh.vertices[r].x();
  });
  Sets sets(mesh.vertices.size());
  for (std::size_t i = 0; i < open.size(); ++i) {
    for (std::size_t j = i + 1;
         j < open.size() && mesh.vertices[open[j]].x() <= mesh.vertices[open[i]].x() + width_m; ++j)
      if ((mesh.vertices[open[i]] - mesh.vertices[open[j]]).norm() <= width_m) sets.join(open[i], open[j]);
  }
  for (Triangle& corner : mesh.triangles)
    for (std::uint32_t& v : corner) v = sets.find(v);
  std::erase_if(mesh.triangles, collapsed);
  Mended mended;
  for (const std::uint32_t v : open)
    if (sets.find(v) != v) mended.add(mesh.vertices[v]);
  return mended;
}

Sets::Sets(std::size_t n) : parent_(n) {
  std::iota(parent_.begin(), parent_.end(), 0u);
}

std::uint32_t Sets::find(std::uint32_t i) {
  while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
  return i;
}

void Sets::join(std::uint32_t i, std::uint32_t j) {
  i = find(i);
  j = find(j);
  parent_[std::max(i, j)] = std::min(i, j);
}

}  // namespace fulcrum
