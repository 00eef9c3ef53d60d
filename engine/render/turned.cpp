#include "engine/render/turned.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace fulcrum::render {
namespace {

constexpr int kColumns = 40;
constexpr float kSmooth = 0.766F;  // cosine of the largest bend without an edge

// A normal in the plane of the profile: x off the axis, y along it.
glm::vec2 normal_of(const Turned& from, const Turned& to) {
  return glm::normalize(glm::vec2(to.along - from.along, from.radius - to.radius));
}

glm::vec2 smoothed(const glm::vec2& own, const glm::vec2& other) {
  return glm::dot(own, other) > kSmooth ? glm::normalize(own + other) : own;
}

}  // namespace

void add_turned(Mesh& mesh, const glm::vec3& foot, const glm::vec3& axis, std::span<const Turned> profile) {
  const glm::vec3 w = glm::normalize(axis);
  const glm::vec3 aside = std::abs(w.y) < 0.9F ? glm::vec3(0.0F, 1.0F, 0.0F) : glm::vec3(1.0F, 0.0F, 0.0F);
  const glm::vec3 u = glm::normalize(glm::cross(aside, w));
  const glm::vec3 v = glm::cross(w, u);
  std::vector<glm::vec2> normals;
  for (std::size_t i = 0; i + 1 < profile.size(); ++i)
    normals.push_back(normal_of(profile[i], profile[i + 1]));
  const auto add_ring = [&](const Turned& at, const glm::vec2& normal) {
    for (int k = 0; k <= kColumns; ++k) {
      const float angle = 2.0F * std::numbers::pi_v<float> * static_cast<float>(k) / kColumns;
      const glm::vec3 out = std::cos(angle) * u + std::sin(angle) * v;
      mesh.positions.push_back(foot + at.radius * out + at.along * w);
      mesh.normals.push_back(normal.x * out + normal.y * w);
    }
  };
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const auto second = first + kColumns + 1;
    add_ring(profile[i], i > 0 ? smoothed(normals[i], normals[i - 1]) : normals[i]);
    add_ring(profile[i + 1], i + 1 < normals.size() ? smoothed(normals[i], normals[i + 1]) : normals[i]);
    for (std::uint32_t k = 0; k < kColumns; ++k) {
      if (profile[i].radius > 0.0F)
        mesh.indices.insert(mesh.indices.end(), {first + k, first + k + 1, second + k});
      if (profile[i + 1].radius > 0.0F)
        mesh.indices.insert(mesh.indices.end(), {first + k + 1, second + k + 1, second + k});
    }
  }
}

void add_bar(Mesh& mesh, const glm::vec3& from, const glm::vec3& to, float radius_from, float radius_to) {
  const float length = glm::distance(from, to);
  const float bevel = 0.15F * std::min({radius_from, radius_to, length});
  if (!(bevel > 0.0F)) return;
  const std::array profile = {Turned{0.0F, 0.0F},
                              Turned{radius_from - bevel, 0.0F},
                              Turned{radius_from, bevel},
                              Turned{radius_to, length - bevel},
                              Turned{radius_to - bevel, length},
                              Turned{0.0F, length}};
  add_turned(mesh, from, to - from, profile);
}

void add_ball(Mesh& mesh, const glm::vec3& centre, float radius) {
  constexpr int steps = 16;
  std::array<Turned, steps + 1> profile;
  for (int i = 0; i <= steps; ++i) {
    const float angle = std::numbers::pi_v<float> * static_cast<float>(i) / steps;
    const bool pole = i == 0 || i == steps;
    profile[static_cast<std::size_t>(i)] = {pole ? 0.0F : radius * std::sin(angle),
                                            -radius * std::cos(angle)};
  }
  add_turned(mesh, centre, {0.0F, 1.0F, 0.0F}, profile);
}

}  // namespace fulcrum::render
