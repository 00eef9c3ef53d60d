#include "tests/piping/path_audit.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace fulcrum::test {
namespace {

constexpr double kPassageDepth = 1e-3;  // m, half of the thinnest wall

// m: no place between a and b, at those distances, is deeper. A distance changes no faster than the way; the
// way is halved for as long as that alone does not say that it stays out of the middle of a wall.
double depth_between(const TriangleDistance& exact, const Vec3& a, double at_a, const Vec3& b, double at_b) {
  constexpr double shortest = 50e-6;  // m
  const double way = (b - a).norm(), bound = 0.5 * (way - at_a - at_b);
  if (bound < kPassageDepth || way < shortest) return bound;
  const Vec3 middle = 0.5 * (a + b);
  const double at_middle = exact.signed_distance(middle);
  return std::max(depth_between(exact, a, at_a, middle, at_middle),
                  depth_between(exact, middle, at_middle, b, at_b));
}

}  // namespace

PathAudit::PathAudit(const Solid& scene_W, const Pointshell& shell_T)
    : exact_(scene_W), scene_(scene_W), shell_(shell_T), points_(shell_T.size()) {}

void PathAudit::move(const Pose& X_WT) {
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Vec3 p_W = X_WT * shell_.positions[i];
    if (!started_) {
      points_[i].p_W = p_W;
      points_[i].room = 0;
    }
    points_[i].room -= (p_W - points_[i].p_W).norm();
    // A distance is 1-Lipschitz: a point that has travelled less than its distance has met nothing.
    if (points_[i].room <= 0) check(i, p_W);
    points_[i].p_W = p_W;
  }
  started_ = true;
}

void PathAudit::check(std::size_t i, const Vec3& p_W) {
  Point& point = points_[i];
  const auto normal_of = [this](std::uint32_t t) {
    const Triangle& triangle = scene_.mesh.triangles[t];
    const Vec3& a = scene_.mesh.vertices[triangle[0]];
    return Vec3(
        (scene_.mesh.vertices[triangle[1]] - a).cross(scene_.mesh.vertices[triangle[2]] - a).normalized());
  };
  const ClosestPoint now = exact_.closest(p_W);
  const bool inside = now.distance < 0;
  const auto first = exact_.first_crossing(point.p_W, p_W);
  const double on_the_way =
      depth_between(exact_, point.p_W, exact_.signed_distance(point.p_W), p_W, now.distance);
  point.deepest = std::max(point.inside ? point.deepest : 0.0, on_the_way);
  if (first) ++crossings_;
  if (!point.inside && first) point.entry_normal = normal_of(first->triangle);
  if (!inside && (point.inside || first)) {
    const auto last = exact_.first_crossing(p_W, point.p_W);
    leave(i, p_W, last ? normal_of(last->triangle) : now.normal);
  } else if (inside && !point.inside && !first) {
    point.entry_normal = now.normal;  // it started inside
  }
  point.inside = inside;
  point.room = std::max(now.distance, 0.0);  // inside, every tick's depth counts
  deepest_ = std::max(deepest_, -now.distance);
}

void PathAudit::leave(std::size_t i, const Vec3& p_W, const Vec3& exit_normal) {
  if (points_[i].entry_normal.dot(exit_normal) > 0) return;
  // Round an edge of a bolt or a flange a point may leave by the next face. The thinnest wall is 2 mm: what
  // was never half of that deep has not been in the middle of one.
  if (points_[i].deepest < kPassageDepth) return;
  ++passages_;
  if (!first_passage_.empty()) return;
  std::ostringstream text;
  text << "shell point " << i << " came out at (" << p_W.transpose() << ") m";
  first_passage_ = text.str();
}

}  // namespace fulcrum::test
