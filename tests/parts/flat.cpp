#include "tests/parts/flat.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

namespace fulcrum::parts {

Flat star(const std::vector<Vec2>& outline, const Vec2& middle) {
  Flat flat{outline, {}};
  const auto n = static_cast<std::uint32_t>(outline.size());
  flat.points.push_back(middle);
  for (std::uint32_t i = 0; i < n; ++i) flat.triangles.push_back({i, (i + 1) % n, n});
  return flat;
}

Flat ring(const std::vector<Vec2>& inner, const std::vector<Vec2>& outer) {
  Flat flat{inner, {}};
  const auto n = static_cast<std::uint32_t>(inner.size());
  flat.points.insert(flat.points.end(), outer.begin(), outer.end());
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    flat.triangles.push_back({i, n + i, n + j});
    flat.triangles.push_back({i, n + j, j});
  }
  return flat;
}

Flat columns(const std::vector<double>& x, const std::vector<double>& low, const std::vector<double>& high) {
  Flat flat;
  std::map<std::pair<double, double>, std::uint32_t> known;
  const auto point = [&](double px, double py) {
    const auto [at, fresh] = known.try_emplace({px, py}, static_cast<std::uint32_t>(flat.points.size()));
    if (fresh) flat.points.emplace_back(px, py);
    return at->second;
  };
  const std::size_t count = low.size();
  // Heights at which the edge between columns i - 1 and i has a point.
  const auto cuts = [&](std::size_t i) {
    std::set<double> all;
    for (const std::size_t column : {i - 1, i})
      if (column < count) all.insert({low[column], high[column]});
    return all;
  };
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<std::uint32_t> outline;  // counter-clockwise: up at the right, down at the left
    const std::set<double> left = cuts(i), right = cuts(i + 1);
    const auto within = [&](double y) { return y >= low[i] && y <= high[i]; };
    for (const double y : right)
      if (within(y)) outline.push_back(point(x[i + 1], y));
    for (auto y = left.rbegin(); y != left.rend(); ++y)
      if (within(*y)) outline.push_back(point(x[i], *y));
    const std::uint32_t middle = point((x[i] + x[i + 1]) / 2, (low[i] + high[i]) / 2);
    for (std::size_t k = 0; k < outline.size(); ++k)
      flat.triangles.push_back({outline[k], outline[(k + 1) % outline.size()], middle});
  }
  return flat;
}

TriangleMesh extruded(const Flat& flat, double low, double high) {
  TriangleMesh mesh;
  const auto n = static_cast<std::uint32_t>(flat.points.size());
  for (const double z : {low, high})
    for (const Vec2& p : flat.points) mesh.vertices.emplace_back(p.x(), p.y(), z);
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const Triangle& t : flat.triangles) {
    mesh.triangles.push_back({t[0], t[2], t[1]});
    mesh.triangles.push_back({n + t[0], n + t[1], n + t[2]});
    for (std::size_t e = 0; e < 3; ++e) edges.insert({t[e], t[(e + 1) % 3]});
  }
  for (const auto& [a, b] : edges) {
    if (edges.contains({b, a})) continue;
    mesh.triangles.push_back({a, b, n + b});
    mesh.triangles.push_back({a, n + b, n + a});
  }
  return mesh;
}

std::vector<Vec2> circle(double radius, int n, double from_rad) {
  std::vector<Vec2> points;
  for (int i = 0; i < n; ++i) {
    const double angle = from_rad + 2 * std::numbers::pi * i / n;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return points;
}

TriangleMesh moved(TriangleMesh mesh, const Eigen::Isometry3d& X) {
  for (Vec3& p : mesh.vertices) p = X * p;
  return mesh;
}

void append(TriangleMesh& to, const TriangleMesh& more) {
  const auto first = static_cast<std::uint32_t>(to.vertices.size());
  to.vertices.insert(to.vertices.end(), more.vertices.begin(), more.vertices.end());
  for (const Triangle& t : more.triangles) to.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

}  // namespace fulcrum::parts
