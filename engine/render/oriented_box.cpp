#include "engine/render/oriented_box.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fulcrum::render {
namespace {

glm::dmat3 covariance_of(std::span<const glm::vec3> positions) {
  glm::dvec3 sum(0.0);
  for (const glm::vec3& p : positions) sum += glm::dvec3(p);
  const glm::dvec3 middle = sum / static_cast<double>(positions.size());
  glm::dmat3 covariance(0.0);
  for (const glm::vec3& p : positions) {
    const glm::dvec3 from = glm::dvec3(p) - middle;
    covariance += glm::outerProduct(from, from);
  }
  return covariance;
}

// Eigenvectors of a symmetric matrix, as columns: Jacobi's rotations, each of which takes one element beside
// the diagonal away.
glm::dmat3 eigenvectors_of(glm::dmat3 a) {
  constexpr int kSweeps = 8;  // far more than three columns need
  glm::dmat3 axes(1.0);
  for (int sweep = 0; sweep < kSweeps; ++sweep)
    for (const auto& [p, q] : {std::pair(0, 1), {0, 2}, {1, 2}}) {
      if (!(std::abs(a[p][q]) > 0.0)) continue;
      const double angle = 0.5 * std::atan2(2.0 * a[p][q], a[q][q] - a[p][p]);
      const double c = std::cos(angle), s = std::sin(angle);
      glm::dmat3 turn(1.0);
      turn[p][p] = turn[q][q] = c;
      turn[p][q] = -s;
      turn[q][p] = s;
      a = glm::transpose(turn) * a * turn;
      axes = axes * turn;
    }
  return axes;
}

OrientedBox box_along(const glm::mat3& axes, std::span<const glm::vec3> positions) {
  const auto along = [&](const glm::vec3& p) { return glm::transpose(axes) * p; };
  OrientedBox box{axes, {along(positions.front()), along(positions.front())}};
  for (const glm::vec3& p : positions) box.bounds = united(box.bounds, {along(p), along(p)});
  return box;
}

float volume_of(const OrientedBox& box) {
  const glm::vec3 size = box.bounds.high - box.bounds.low;
  return size.x * size.y * size.z;
}

}  // namespace

OrientedBox oriented_box_of(std::span<const glm::vec3> positions) {
  const OrientedBox upright = box_along(glm::mat3(1.0F), positions);
  const OrientedBox turned = box_along(glm::mat3(eigenvectors_of(covariance_of(positions))), positions);
  return volume_of(turned) < volume_of(upright) ? turned : upright;
}

float distance_to(const OrientedBox& box, const glm::mat4& X, const glm::vec3& point) {
  const glm::vec3 own = glm::transpose(box.axes) * glm::vec3(glm::inverse(X) * glm::vec4(point, 1.0F));
  const auto away = [&](const glm::vec3& place) {
    return glm::distance(point, glm::vec3(X * glm::vec4(box.axes * place, 1.0F)));
  };
  const glm::vec3 nearest = glm::clamp(own, box.bounds.low, box.bounds.high);
  if (nearest != own) return away(nearest);
  float farthest = 0.0F;
  for (const glm::vec3& corner : corners(box.bounds)) farthest = std::max(farthest, away(corner));
  return farthest;
}

}  // namespace fulcrum::render
