#include "tools/content/mesh/shading.h"

#include <algorithm>
#include <optional>

#include "haptics/math/functions.h"

namespace fulcrum::content {
namespace {

struct Corner {
  std::uint32_t triangle;
  Eigen::Vector3d weighted_normal;
};

Eigen::Vector3d face_normal(const Solid& solid, const Triangle& t) {
  const Eigen::Vector3d& a = solid.points[t[0]];
  return (solid.points[t[1]] - a).cross(solid.points[t[2]] - a);
}

double corner_angle(const Solid& solid, const Triangle& t, std::size_t k) {
  const Eigen::Vector3d& p = solid.points[t[k]];
  const Eigen::Vector3d u = (solid.points[t[(k + 1) % 3]] - p).normalized();
  const Eigen::Vector3d v = (solid.points[t[(k + 2) % 3]] - p).normalized();
  return math::acos(std::clamp(u.dot(v), -1.0, 1.0));
}

}  // namespace

ShadedMesh shade(const Solid& solid, double crease, const std::vector<Eigen::Vector3d>& colours) {
  std::vector<Eigen::Vector3d> unit_normals;
  std::vector<std::vector<Corner>> corners_at(solid.points.size());
  for (std::uint32_t i = 0; i < solid.triangles.size(); ++i) {
    const Triangle& t = solid.triangles[i];
    const Eigen::Vector3d normal = face_normal(solid, t);
    unit_normals.push_back(normal.normalized());
    // Weighting by area as well keeps a flat face flat beside a narrow fillet.
    for (std::size_t k = 0; k < 3; ++k) corners_at[t[k]].push_back({i, corner_angle(solid, t, k) * normal});
  }

  ShadedMesh mesh;
  std::vector<std::vector<std::uint32_t>> drawn_at(solid.points.size());
  const double cos_crease = math::cos(crease);
  for (std::uint32_t i = 0; i < solid.triangles.size(); ++i) {
    for (const std::uint32_t point : solid.triangles[i]) {
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (const Corner& corner : corners_at[point])
        if (unit_normals[corner.triangle].dot(unit_normals[i]) > cos_crease) sum += corner.weighted_normal;
      const Eigen::Vector3f normal = sum.normalized().cast<float>();
      auto& drawn = drawn_at[point];
      const auto same = std::find_if(drawn.begin(), drawn.end(), [&](std::uint32_t v) {
        return (mesh.normals[v] - normal).norm() < 1e-4F;
      });
      if (same != drawn.end()) {
        mesh.indices.push_back(*same);
        continue;
      }
      const auto vertex = static_cast<std::uint32_t>(mesh.positions.size());
      mesh.positions.push_back(solid.points[point].cast<float>());
      mesh.normals.push_back(normal);
      if (!colours.empty()) mesh.colours.push_back(colours[point].cast<float>());
      mesh.indices.push_back(vertex);
      drawn.push_back(vertex);
    }
  }
  return mesh;
}

std::vector<Eigen::Vector2f> split_at_seams(ShadedMesh* mesh, const CornerUv& corners) {
  const std::size_t vertices = mesh->positions.size();
  std::vector<std::optional<Eigen::Vector2f>> placed(vertices);
  std::vector<std::vector<std::uint32_t>> others(vertices);
  for (std::size_t i = 0; i < mesh->indices.size(); ++i) {
    std::uint32_t& index = mesh->indices[i];
    const std::uint32_t vertex = index;
    const Eigen::Vector2f uv = corners[i / 3][i % 3].cast<float>();
    const auto is_there = [&](std::uint32_t v) { return (*placed[v] - uv).norm() < 1e-5F; };
    if (!placed[vertex]) placed[vertex] = uv;
    if (is_there(vertex)) continue;
    const auto known = std::ranges::find_if(others[vertex], is_there);
    if (known != others[vertex].end()) {
      index = *known;
      continue;
    }
    index = static_cast<std::uint32_t>(placed.size());
    others[vertex].push_back(index);
    placed.emplace_back(uv);
    mesh->positions.push_back(Eigen::Vector3f(mesh->positions[vertex]));
    mesh->normals.push_back(Eigen::Vector3f(mesh->normals[vertex]));
    if (!mesh->colours.empty()) mesh->colours.push_back(Eigen::Vector3f(mesh->colours[vertex]));
  }
  std::vector<Eigen::Vector2f> uv;
  for (const auto& place : placed) uv.push_back(place.value_or(Eigen::Vector2f::Zero()));
  return uv;
}

}  // namespace fulcrum::content
