#include "tests/parts/exact_depth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace fulcrum::parts {
namespace {

using Corners = std::array<Vec3, 3>;

constexpr double kBeside = 1e-12;  // m

// Squared, of a point from a triangle (C. Ericson, "Real-Time Collision Detection", 2005, 5.1.5).
double squared_distance(const Vec3& p, const Corners& t) {
  const Vec3 ab = t[1] - t[0], ac = t[2] - t[0], ap = p - t[0];
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return ap.squaredNorm();
  const Vec3 bp = p - t[1];
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return bp.squaredNorm();
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return (ap - d1 / (d1 - d3) * ab).squaredNorm();
  const Vec3 cp = p - t[2];
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return cp.squaredNorm();
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return (ap - d2 / (d2 - d6) * ac).squaredNorm();
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
    return (bp - (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (t[2] - t[1])).squaredNorm();
  const double sum = va + vb + vc;
  return (ap - vb / sum * ab - vc / sum * ac).squaredNorm();
}

// The solid angle of a triangle seen from a point (A. van Oosterom, J. Strackee, IEEE Trans. Biomed. Eng.
// 30(2), 1983), rad: all of a closed surface's add up to 4 pi inside and to nothing outside.
double solid_angle(const Vec3& p, const Corners& t) {
  const Vec3 a = t[0] - p, b = t[1] - p, c = t[2] - p;
  const double na = a.norm(), nb = b.norm(), nc = c.norm();
  return 2 * std::atan2(a.dot(b.cross(c)), na * nb * nc + a.dot(b) * nc + b.dot(c) * na + c.dot(a) * nb);
}

}  // namespace

struct ExactDepth::Body {
  struct Node {
    Box3 box;
    std::size_t first = 0, count = 0;  // of triangles, where it is a leaf
    std::size_t left = 0;              // its children: left and left + 1
  };

  Body(const TriangleMesh& mesh, double spacing) {
    for (const Triangle& t : mesh.triangles)
      triangles.push_back({mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]});
    nodes.emplace_back();
    split(0, 0, triangles.size());
    for (const Vec3& p : mesh.vertices) samples.push_back(p);
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const Triangle& t : mesh.triangles)
      for (std::size_t e = 0; e < 3; ++e) edges.insert(std::minmax(t[e], t[(e + 1) % 3]));
    for (const auto& [i, j] : edges) {
      const Vec3 a = mesh.vertices[i], way = mesh.vertices[j] - a;
      const auto steps = static_cast<int>(std::ceil(way.norm() / spacing));
      for (int k = 1; k < steps; ++k) samples.emplace_back(a + way * k / steps);
    }
    for (const Corners& t : triangles) {
      const Vec3 u = t[1] - t[0], v = t[2] - t[0];
      const auto steps =
          static_cast<int>(std::ceil(std::max({u.norm(), v.norm(), (u - v).norm()}) / spacing));
      for (int i = 1; i < steps; ++i)
        for (int j = 1; i + j < steps; ++j) samples.emplace_back(t[0] + u * i / steps + v * j / steps);
    }
  }

  void split(std::size_t at, std::size_t first, std::size_t count) {
    Box3 box, middles;
    for (std::size_t i = first; i < first + count; ++i) {
      for (const Vec3& p : triangles[i]) box.extend(p);
      middles.extend(Vec3((triangles[i][0] + triangles[i][1] + triangles[i][2]) / 3));
    }
    nodes[at] = {box, first, count, 0};
    if (count <= 4) return;
    Eigen::Index axis = 0;
    middles.sizes().maxCoeff(&axis);
    const auto from = triangles.begin() + static_cast<std::ptrdiff_t>(first);
    const auto half = static_cast<std::ptrdiff_t>(count / 2);
    std::nth_element(from, from + half, from + static_cast<std::ptrdiff_t>(count),
                     [axis](const Corners& a, const Corners& b) {
                       return a[0][axis] + a[1][axis] + a[2][axis] < b[0][axis] + b[1][axis] + b[2][axis];
                     });
    const std::size_t left = nodes.size();
    nodes.resize(left + 2);
    nodes[at].left = left;
    nodes[at].count = 0;
    split(left, first, count / 2);
    split(left + 1, first + count / 2, count - count / 2);
  }

  // Squared, up to `most`.
  double nearest(const Vec3& p, double most) const {
    std::vector<std::size_t> open{0};
    double least = most;
    while (!open.empty()) {
      const Node& node = nodes[open.back()];
      open.pop_back();
      if (node.box.squaredExteriorDistance(p) >= least) continue;
      for (std::size_t i = 0; i < node.count; ++i)
        least = std::min(least, squared_distance(p, triangles[node.first + i]));
      if (node.count > 0) continue;
      // The nearer child is looked into first.
      const double l = nodes[node.left].box.squaredExteriorDistance(p),
                   r = nodes[node.left + 1].box.squaredExteriorDistance(p);
      open.push_back(l < r ? node.left + 1 : node.left);
      open.push_back(l < r ? node.left : node.left + 1);
    }
    return least;
  }

  // How often the surface winds around the point, by what a ray passes; none: it passes an edge.
  std::optional<int> winding(const Vec3& p, const Vec3& way) const {
    int winding = 0;
    std::vector<std::size_t> open{0};
    const Vec3 inverse = way.cwiseInverse();
    while (!open.empty()) {
      const Node& node = nodes[open.back()];
      open.pop_back();
      const Vec3 low = (node.box.min() - p).cwiseProduct(inverse),
                 high = (node.box.max() - p).cwiseProduct(inverse);
      const double from = low.cwiseMin(high).maxCoeff(), to = low.cwiseMax(high).minCoeff();
      if (to < std::max(from, 0.0) - kBeside) continue;
      for (std::size_t i = 0; i < node.count; ++i) {
        const Corners& t = triangles[node.first + i];
        const Vec3 u = t[1] - t[0], v = t[2] - t[0], n = u.cross(v), to_p = p - t[0];
        const double det = -way.dot(n);
        if (std::abs(det) < 1e-9 * n.norm()) return std::nullopt;
        const Vec3 q = to_p.cross(way);
        const double b = v.dot(q) / det, c = -u.dot(q) / det, at = to_p.dot(n) / det;
        const double least = std::min({b, c, 1 - b - c});
        if (least < -1e-9 || at < -kBeside) continue;
        if (least < 1e-9) return std::nullopt;
        if (at > 0) winding += det < 0 ? 1 : -1;
      }
      if (node.count > 0) continue;
      open.push_back(node.left);
      open.push_back(node.left + 1);
    }
    return winding;
  }

  bool holds(const Vec3& p) const {
    for (const Vec3& way :
         {Vec3(0.571, 0.352, 0.742), Vec3(-0.613, 0.517, 0.598), Vec3(0.278, -0.811, 0.514)})
      if (const std::optional<int> times = winding(p, way.normalized())) return *times > 0;
    double sum = 0;
    for (const Corners& t : triangles) sum += solid_angle(p, t);
    return sum > 2 * std::numbers::pi;
  }

  // m: how deep the deepest of those points is in here.
  double deepest(const std::vector<Vec3>& points, const Pose& X) const {
    constexpr double farthest = 2e-3;  // m, deeper than that nothing is told apart
    double depth = 0;
    for (const Vec3& point : points) {
      const Vec3 p = X * point;
      if (!nodes[0].box.contains(p)) continue;
      const double distance = std::sqrt(nearest(p, farthest * farthest));
      if (distance > depth && holds(p)) depth = distance;
    }
    return depth;
  }

  std::vector<Corners> triangles;
  std::vector<Node> nodes;
  std::vector<Vec3> samples;
};

ExactDepth::ExactDepth(const TriangleMesh& tool_T, const TriangleMesh& scene_W, double spacing)
    : tool_(std::make_unique<Body>(tool_T, spacing)), scene_(std::make_unique<Body>(scene_W, spacing)) {}
ExactDepth::~ExactDepth() = default;

double ExactDepth::at(const Pose& X_WT) const {
  return std::max(scene_->deepest(tool_->samples, X_WT), tool_->deepest(scene_->samples, X_WT.inverse()));
}

}  // namespace fulcrum::parts
