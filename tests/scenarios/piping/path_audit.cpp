#include "tests/scenarios/piping/path_audit.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "haptics/math/rotation.h"
#include "haptics/tool/rigid_body.h"

namespace fulcrum::test {
namespace {

constexpr double kStep = 0.2e-3;  // m, the straight parts that a point's way near the scene is cut into

}  // namespace

PathAudit::PathAudit(const Solid& scene_W, const Pointshell& shell_T)
    : exact_(scene_W), scene_(scene_W), shell_(shell_T), points_(shell_T.size()) {
  for (std::size_t i = 0; i < points_.size(); ++i) points_[i].radius = shell_T.positions[i].norm();
}

void PathAudit::move(const Pose& X_WT) {
  if (!started_) X_WT_ = X_WT;
  started_ = true;
  const Twist along{X_WT.p - X_WT_.p, rotation_vector(X_WT.q * X_WT_.q.conjugate())};
  const double travel = along.v.norm(), turn = along.w.norm();
  for (std::size_t i = 0; i < points_.size(); ++i) walk(i, along, travel + turn * points_[i].radius);
  X_WT_ = X_WT;
}

// along: from the last pose, over one unit of time; travel: m, the point's way is no longer.
void PathAudit::walk(std::size_t i, const Twist& along, double travel) {
  Point& point = points_[i];
  // A distance is 1-Lipschitz: a point that has travelled less than its distance has met nothing.
  if (point.room > travel) {
    point.room -= travel;
    return;
  }
  Vec3 p_W = X_WT_ * shell_.positions[i];
  for (double t = 0; t < 1;) {
    const double step = std::max(point.room, kStep);
    const double next = step < (1 - t) * travel ? t + step / travel : 1.0;
    const Vec3 next_W = RigidBody::advance(X_WT_, along, next) * shell_.positions[i];
    point.room -= (next - t) * travel;
    if (point.room <= 0) check(i, p_W, next_W);
    p_W = next_W;
    t = next;
  }
}

void PathAudit::check(std::size_t i, const Vec3& p0_W, const Vec3& p_W) {
  Point& point = points_[i];
  const auto normal_of = [this](std::uint32_t t) {
    const Triangle& triangle = scene_.mesh.triangles[t];
    const Vec3& a = scene_.mesh.vertices[triangle[0]];
    return Vec3(
        (scene_.mesh.vertices[triangle[1]] - a).cross(scene_.mesh.vertices[triangle[2]] - a).normalized());
  };
  const ClosestPoint now = exact_.closest(p_W);
  const bool inside = now.distance < 0;
  const auto first = exact_.first_crossing(p0_W, p_W);
  // Nowhere on the way here was it deeper: a distance changes no faster than the way.
  const double on_the_way = (p_W - p0_W).norm() - now.distance;
  point.deepest = std::max(point.inside ? point.deepest : 0.0, on_the_way);
  if (first) ++crossings_;
  if (!point.inside && first) point.entry_normal = normal_of(first->triangle);
  if (!inside && (point.inside || first)) {
    const auto last = exact_.first_crossing(p_W, p0_W);
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
  // was never 1 mm deep has not been in the middle of one.
  if (points_[i].deepest < 1e-3) return;
  ++passages_;
  if (!first_passage_.empty()) return;
  std::ostringstream text;
  text << "shell point " << i << " came out at (" << p_W.transpose() << ") m";
  first_passage_ = text.str();
}

}  // namespace fulcrum::test
