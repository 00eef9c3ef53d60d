#include "tests/bench/deepest_point.h"

#include <algorithm>
#include <limits>

#include "haptics/geometry/kd_order.h"

namespace fulcrum::bench {
namespace {

constexpr std::size_t kFan = 16;
using Corners = std::array<Vec3, 3>;

Vec3 middle_of(const Corners& t) {
  return (t[0] + t[1] + t[2]) / 3;
}

double radius_about(const Vec3& centre, const Corners& t) {
  return std::sqrt(std::max(
      {(t[0] - centre).squaredNorm(), (t[1] - centre).squaredNorm(), (t[2] - centre).squaredNorm()}));
}

}  // namespace

struct DeepestPoint::Search {
  const DeepestPoint& tool;
  Mat3 R_WT;
  Vec3 p_WT;
  double tolerance;
  double best = -kNothing;
  double enough = std::numeric_limits<double>::infinity();  // m, a depth beyond which nothing more is asked

  Nearest at(const Vec3& p_T) const { return nearest_pipe(tool.pipes_, R_WT * p_T + p_WT); }
  bool hopeless(double most) const { return most <= best + tolerance || best > enough; }

  // No point of the triangle is deeper.
  double most_within(const Nearest& centre, const Vec3& centre_T, double radius, const Corners& t) const {
    const double lipschitz = -centre.distance + radius;
    if (!hopeless(-centre.runner_up + radius) || centre.bend * radius > 0.5) return lipschitz;
    double slope = 0;
    for (const Vec3& corner : t) slope = std::max(slope, -centre.normal.dot(R_WT * (corner - centre_T)));
    // The curvature grows towards the bend's centre: twice what it is here, within half of the way there.
    return std::min(lipschitz, -centre.distance + slope + centre.bend * radius * radius);
  }

  void visit(const Corners& t) {
    const Vec3 centre_T = middle_of(t);
    const double radius = radius_about(centre_T, t);
    const Nearest centre = at(centre_T);
    if (hopeless(-centre.distance + radius)) return;
    best = std::max(best, -centre.distance);
    for (const Vec3& corner : t) best = std::max(best, -at(corner).distance);
    if (hopeless(most_within(centre, centre_T, radius, t))) return;
    const Vec3 ab = (t[0] + t[1]) / 2, bc = (t[1] + t[2]) / 2, ca = (t[2] + t[0]) / 2;
    for (const Corners& part : {Corners{ab, bc, ca}, {t[0], ab, ca}, {ab, t[1], bc}, {ca, bc, t[2]}})
      visit(part);
  }

  void visit(std::size_t level, std::size_t node) {
    const Ball& ball = tool.levels_[level][node];
    if (hopeless(-at(ball.centre).distance + ball.radius)) return;
    const std::size_t count = level == 0 ? tool.triangles_.size() : tool.levels_[level - 1].size();
    for (std::size_t i = node * kFan; i < std::min(count, (node + 1) * kFan); ++i)
      if (level == 0)
        visit(tool.triangles_[i]);
      else
        visit(level - 1, i);
  }
};

DeepestPoint::DeepestPoint(const TriangleMesh& tool_T, std::vector<SweptPipe> pipes)
    : pipes_(std::move(pipes)) {
  std::vector<Vec3> middles;
  const auto corners_of = [&](const Triangle& t) {
    return Corners{tool_T.vertices[t[0]], tool_T.vertices[t[1]], tool_T.vertices[t[2]]};
  };
  for (const Triangle& t : tool_T.triangles) middles.push_back(middle_of(corners_of(t)));
  for (const std::uint32_t i : kd_order(middles)) triangles_.push_back(corners_of(tool_T.triangles[i]));
  for (std::size_t run = kFan;; run *= kFan) {
    std::vector<Ball>& balls = levels_.emplace_back();
    for (std::size_t first = 0; first < triangles_.size(); first += run) {
      const std::size_t end = std::min(first + run, triangles_.size());
      Box3 box;
      for (std::size_t i = first; i < end; ++i)
        for (const Vec3& corner : triangles_[i]) box.extend(corner);
      Ball ball{box.center(), 0};
      for (std::size_t i = first; i < end; ++i)
        ball.radius = std::max(ball.radius, radius_about(ball.centre, triangles_[i]));
      balls.push_back(ball);
    }
    if (balls.size() == 1) break;
  }
}

double DeepestPoint::depth(const Pose& X_WT, double tolerance) const {
  Search search{*this, X_WT.q.toRotationMatrix(), X_WT.p, tolerance};
  search.visit(levels_.size() - 1, 0);
  return search.best;
}

bool DeepestPoint::deeper_than(double limit, const Pose& X_WT, double tolerance) const {
  Search search{*this, X_WT.q.toRotationMatrix(), X_WT.p, tolerance, limit, limit};
  search.visit(levels_.size() - 1, 0);
  return search.best > limit;
}

}  // namespace fulcrum::bench
