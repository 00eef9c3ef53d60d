#include "haptics/bake/holes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "haptics/bake/t_junctions.h"

namespace fulcrum {
namespace {

// The boundary's edges turned round, from each vertex to the next ones: what the fills have to run along.
std::map<std::uint32_t, std::vector<std::uint32_t>> missing_edges(const TriangleMesh& mesh) {
  std::map<std::uint32_t, std::vector<std::uint32_t>> next;
  EdgeFans(mesh.triangles).for_each([&next](std::span<const HalfEdge> fan) {
    int surplus = 0;
    for (const HalfEdge& edge : fan) surplus += edge.forward ? 1 : -1;
    for (; surplus > 0; --surplus) next[fan[0].high].push_back(fan[0].low);
    for (; surplus < 0; ++surplus) next[fan[0].low].push_back(fan[0].high);
  });
  return next;
}

// A boundary enters every vertex as often as it leaves it, so that a walk along it comes round; whenever it
// meets itself, a rim is complete.
std::vector<std::vector<std::uint32_t>> rims_of(const TriangleMesh& mesh) {
  auto next = missing_edges(mesh);
  std::vector<std::vector<std::uint32_t>> rims;
  while (!next.empty()) {
    std::vector<std::uint32_t> path{next.begin()->first};
    std::map<std::uint32_t, std::size_t> place{{path[0], 0}};
    while (!path.empty()) {
      const auto from = next.find(path.back());
      if (from == next.end()) break;
      const std::uint32_t to = from->second.back();
      from->second.pop_back();
      if (from->second.empty()) next.erase(from);
      const auto [met, is_new] = place.try_emplace(to, path.size());
      if (is_new) {
        path.push_back(to);
        continue;
      }
      rims.emplace_back(path.begin() + static_cast<std::ptrdiff_t>(met->second), path.end());
      for (std::size_t i = met->second + 1; i < path.size(); ++i) place.erase(path[i]);
      path.resize(met->second + 1);
    }
  }
  return rims;
}

class Ears {
public:
  Ears(const TriangleMesh& mesh, const std::vector<std::uint32_t>& rim) : mesh_(mesh), left_(rim) {
    for (std::size_t i = 0; i < rim.size(); ++i) normal_ += (at(i) - at(0)).cross(at(i + 1) - at(0));
  }

  std::vector<Triangle> cut_all() {
    std::vector<Triangle> triangles;
    while (left_.size() > 3) {
      const std::size_t ear = best_ear(), n = left_.size();
      triangles.push_back({left_[(ear + n - 1) % n], left_[ear], left_[(ear + 1) % n]});
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    triangles.push_back({left_[0], left_[1], left_[2]});
    return triangles;
  }

private:
  const Vec3& at(std::size_t i) const { return mesh_.vertices[left_[i % left_.size()]]; }

  // Twice the area of a triangle as seen along the rim's normal.
  double seen(const Vec3& a, const Vec3& b, const Vec3& c) const { return (b - a).cross(c - a).dot(normal_); }

  // Convex, and no other vertex in it.
  bool is_clear(std::size_t ear) const {
    const std::size_t n = left_.size();
    const Vec3 &a = at(ear + n - 1), &b = at(ear), &c = at(ear + 1);
    if (!(seen(a, b, c) > 0.0)) return false;
    for (std::size_t i = ear + 2; i < ear + n - 1; ++i) {
      const Vec3& p = at(i);
      if (seen(a, b, p) >= 0.0 && seen(b, c, p) >= 0.0 && seen(c, a, p) >= 0.0) return false;
    }
    return true;
  }

  // The clear ear with the shortest diagonal; where the rim is too crooked to have one, the shortest of all.
  std::size_t best_ear() const {
    const std::size_t n = left_.size();
    std::vector<std::pair<double, std::size_t>> by_length;
    for (std::size_t i = 0; i < n; ++i) by_length.emplace_back((at(i + 1) - at(i + n - 1)).squaredNorm(), i);
    std::sort(by_length.begin(), by_length.end());
    const auto clear = std::find_if(by_length.begin(), by_length.end(),
                                    [this](const auto& candidate) { return is_clear(candidate.second); });
    return (clear != by_length.end() ? *clear : by_length.front()).second;
  }

  const TriangleMesh& mesh_;
  std::vector<std::uint32_t> left_;
  Vec3 normal_ = Vec3::Zero();
};

}  // namespace

std::vector<HoleFill> fill_holes(const TriangleMesh& mesh) {
  std::vector<HoleFill> fills;
  for (std::vector<std::uint32_t>& rim : rims_of(mesh)) {
    HoleFill fill;
    fill.triangles = Ears(mesh, rim).cut_all();
    for (const Triangle& triangle : fill.triangles)
      fill.width_m = std::max(fill.width_m, least_height(mesh, triangle));
    for (const std::uint32_t v : rim) fill.place += mesh.vertices[v] / static_cast<double>(rim.size());
    fill.rim = std::move(rim);
    fills.push_back(std::move(fill));
  }
  return fills;
}

}  // namespace fulcrum
