#include "engine/analysis/shapes.h"

#include <map>
#include <numbers>
#include <utility>

#include "haptics/math/functions.h"

namespace fulcrum::analysis {

TriangleMesh ball_mesh(double radius, int splits) {
  TriangleMesh mesh;
  const double t = std::numbers::phi;
  for (const Vec3& p :
       {Vec3(-1, t, 0), Vec3(1, t, 0), Vec3(-1, -t, 0), Vec3(1, -t, 0), Vec3(0, -1, t), Vec3(0, 1, t),
        Vec3(0, -1, -t), Vec3(0, 1, -t), Vec3(t, 0, -1), Vec3(t, 0, 1), Vec3(-t, 0, -1), Vec3(-t, 0, 1)})
    mesh.vertices.push_back(radius * p.normalized());
  mesh.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (; splits > 1; splits /= 2) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [it, fresh] =
          middles.emplace(std::minmax(a, b), static_cast<std::uint32_t>(mesh.vertices.size()));
      if (fresh) mesh.vertices.push_back(radius * (mesh.vertices[a] + mesh.vertices[b]).normalized());
      return it->second;
    };
    std::vector<Triangle> finer;
    for (const Triangle& c : mesh.triangles) {
      const std::uint32_t ab = middle(c[0], c[1]), bc = middle(c[1], c[2]), ca = middle(c[2], c[0]);
      finer.insert(finer.end(), {{c[0], ab, ca}, {c[1], bc, ab}, {c[2], ca, bc}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
  }
  return mesh;
}

TriangleMesh tube_mesh(double inner, double outer, double length, int sides) {
  TriangleMesh mesh;
  const double half = std::numbers::pi / sides, between = 2 / (1 + math::cos(half));
  const auto n = static_cast<std::uint32_t>(sides);
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2 * half * i;
    const Vec3 direction(math::cos(angle), math::sin(angle), 0);
    for (const double radius : {inner, outer})
      for (const double z : {-0.5 * length, 0.5 * length})
        mesh.vertices.push_back(between * radius * direction + Vec3(0, 0, z));
  }
  // Of side i: 4 i + 0 inner low, 1 inner high, 2 outer low, 3 outer high.
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t a = 4 * i, b = 4 * ((i + 1) % n);
    const auto face = [&](std::uint32_t p, std::uint32_t q, std::uint32_t r, std::uint32_t s) {
      mesh.triangles.insert(mesh.triangles.end(), {{p, q, r}, {p, r, s}});
    };
    face(a + 2, b + 2, b + 3, a + 3);
    face(b, a, a + 1, b + 1);
    face(a + 3, b + 3, b + 1, a + 1);
    face(b + 2, a + 2, a, b);
  }
  return mesh;
}

TriangleMesh box_mesh(const Vec3& low, const Vec3& high) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.vertices.emplace_back(i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(),
                               i & 4 ? high.z() : low.z());
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

TriangleMesh moved(TriangleMesh mesh, const Pose& X) {
  for (Vec3& p : mesh.vertices) p = X.q * p + X.p;
  return mesh;
}

TriangleMesh joined(std::span<const TriangleMesh> meshes) {
  TriangleMesh all;
  for (const TriangleMesh& mesh : meshes) {
    const auto base = static_cast<std::uint32_t>(all.vertices.size());
    all.vertices.insert(all.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    for (const Triangle& t : mesh.triangles) all.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  }
  return all;
}

}  // namespace fulcrum::analysis
