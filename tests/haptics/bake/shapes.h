#pragma once
// Closed meshes of known size, wound outwards.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>

#include "haptics/bake/solid.h"

namespace fulcrum::shapes {

inline void append(TriangleMesh& mesh, const TriangleMesh& other) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const Triangle& t : other.triangles)
    mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

inline TriangleMesh box(const Vec3& low, const Vec3& high) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.emplace_back((i & 1) != 0 ? high.x() : low.x(), (i & 2) != 0 ? high.y() : low.y(),
                               (i & 4) != 0 ? high.z() : low.z());
  }
  mesh.triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
  return mesh;
}

inline double box_distance(const Vec3& p, const Vec3& low, const Vec3& high) {
  const Vec3 beyond = (low - p).cwiseMax(p - high);
  return beyond.cwiseMax(0.0).norm() + std::min(beyond.maxCoeff(), 0.0);
}

// A tube of radius r about a circle of radius R in the plane y = 0; n steps around, m across.
inline TriangleMesh torus(double R, double r, std::uint32_t n, std::uint32_t m) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < m; ++j) {
      const double a = 2.0 * std::numbers::pi * i / n, b = 2.0 * std::numbers::pi * j / m;
      const double along = R + r * std::cos(b);
      mesh.vertices.emplace_back(along * std::cos(a), r * std::sin(b), along * std::sin(a));
      const std::uint32_t i1 = (i + 1) % n, j1 = (j + 1) % m;
      mesh.triangles.push_back({i * m + j, i * m + j1, i1 * m + j1});
      mesh.triangles.push_back({i * m + j, i1 * m + j1, i1 * m + j});
    }
  }
  return mesh;
}

// n steps from pole to pole, 2n around.
inline TriangleMesh sphere(const Vec3& centre, double radius, std::uint32_t n) {
  TriangleMesh mesh;
  const std::uint32_t m = 2 * n;
  mesh.vertices.push_back(centre + Vec3(0.0, radius, 0.0));
  for (std::uint32_t i = 1; i < n; ++i) {
    for (std::uint32_t j = 0; j < m; ++j) {
      const double a = std::numbers::pi * i / n, b = 2.0 * std::numbers::pi * j / m;
      mesh.vertices.push_back(
          centre + radius * Vec3(std::sin(a) * std::cos(b), std::cos(a), std::sin(a) * std::sin(b)));
    }
  }
  mesh.vertices.push_back(centre - Vec3(0.0, radius, 0.0));
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return 1 + (i - 1) * m + j % m; };
  const auto south = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
  for (std::uint32_t j = 0; j < m; ++j) {
    mesh.triangles.push_back({0, at(1, j + 1), at(1, j)});
    mesh.triangles.push_back({south, at(n - 1, j), at(n - 1, j + 1)});
    for (std::uint32_t i = 1; i + 1 < n; ++i) {
      mesh.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
    }
  }
  return mesh;
}

// A box whose faces are n x n squares of two triangles each.
inline TriangleMesh grid_box(const Vec3& low, const Vec3& high, std::uint32_t n) {
  TriangleMesh mesh;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    for (const bool upper : {false, true}) {
      const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
      const Eigen::Index u = (axis + 1) % 3, v = (axis + 2) % 3;
      for (std::uint32_t i = 0; i <= n; ++i) {
        for (std::uint32_t j = 0; j <= n; ++j) {
          Vec3 p;
          p[axis] = upper ? high[axis] : low[axis];
          p[u] = low[u] + (high[u] - low[u]) * i / n;
          p[v] = low[v] + (high[v] - low[v]) * j / n;
          mesh.vertices.push_back(p);
        }
      }
      for (std::uint32_t i = 0; i < n; ++i) {
        for (std::uint32_t j = 0; j < n; ++j) {
          const std::uint32_t a = first + i * (n + 1) + j, b = a + n + 1;
          if (upper)
            mesh.triangles.insert(mesh.triangles.end(), {{a, b, b + 1}, {a, b + 1, a + 1}});
          else
            mesh.triangles.insert(mesh.triangles.end(), {{a, b + 1, b}, {a, a + 1, b + 1}});
        }
      }
    }
  }
  return mesh;
}

// What must be possible.
inline Solid solid_of(const TriangleMesh& mesh) {
  const auto solid = build_solid(mesh);
  EXPECT_TRUE(solid) << solid.error().sentence;
  return *solid;
}

inline TriangleMesh rotated(TriangleMesh mesh, const Quat& q) {
  for (Vec3& p : mesh.vertices) p = q * p;
  return mesh;
}

}  // namespace fulcrum::shapes
