#include "haptics/contact/feature_passing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "haptics/geometry/point_triangle.h"
#include "haptics/math/functions.h"

namespace fulcrum {
namespace {

constexpr double kOnFace = 1e-9;          // m, what lies this far beyond a face's rim goes through it
constexpr double kOnLine = 1e-9;          // of an edge's length, beyond its ends likewise
constexpr double kNearlyParallel = 1e-9;  // squared sine of the angle between edges

// Whether a point that lies on a triangle's plane, or at most `depth` under it, is on or under the triangle.
bool is_on_face(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c, double depth) {
  return closest_on_triangle(p, a, b, c).squared <= math::square(depth + kOnFace);
}

// Whether both faces beside an edge (unit directions, along them away from it) are on one side of the plane
// across nhat, but for `slack` rad: above it (sign 1), or below (-1).
bool is_beside(const std::array<Vec3, 2>& ways, const Vec3& nhat, double sign, double slack) {
  return std::min(sign * nhat.dot(ways[0]), sign * nhat.dot(ways[1])) >= -slack;
}

// The one root within 0 to 1 of the parabola through these values there and in the middle; begin >= 0, end
// below 0.
double root_of_parabola(double begin, double middle, double end) {
  const double a = 2 * (begin - 2 * middle + end), b = end - begin - a;
  const double discriminant = std::sqrt(std::max(0.0, b * b - 4 * a * begin));
  const double q = -0.5 * (b + std::copysign(discriminant, b));
  const double first = q != 0 ? begin / q : 0.0;
  if (first >= 0 && first <= 1) return first;
  return std::clamp(a != 0 ? q / a : 0.0, 0.0, 1.0);
}

}  // namespace

FeaturePassing::FeaturePassing(std::shared_ptr<const FeatureMesh> tool_T,
                               std::shared_ptr<const FeatureMesh> scene_W, double slack)
    : tool_(std::move(tool_T)), scene_(std::move(scene_W)), slack_(slack), ends_(tool_->vertices().size()) {}

double FeaturePassing::free_part(const FeatureGathering& gathering, const Pose& X_from, const Pose& X_to,
                                 double in, double depth) noexcept {
  ++steps_;
  X_from_ = X_from;
  X_to_ = X_to;
  R_from_ = X_from.q.toRotationMatrix();
  R_to_ = X_to.q.toRotationMatrix();
  in_ = in;
  depth_ = depth;
  part_ = 1;
  const ToolWay::Place from = gathering.way().place(X_from, tool_->radius()),
                       to = gathering.way().place(X_to, tool_->radius());
  for (const FeatureCandidate& candidate : gathering.candidates(FeatureGathering::kVertexFace))
    if (!candidate.is_apart(from, to, 0) && !is_apart(candidate, {&candidate.tool, 1}))
      vertex_through_face(candidate);
  for (const FeatureCandidate& candidate : gathering.candidates(FeatureGathering::kFaceVertex))
    if (!candidate.is_apart(from, to, 0) && !is_apart(candidate, tool_->faces()[candidate.tool].corners))
      face_over_vertex(candidate);
  for (const FeatureCandidate& candidate : gathering.candidates(FeatureGathering::kEdgeEdge)) {
    if (candidate.is_apart(from, to, 0)) continue;
    const FeatureMesh::Edge& edge = tool_->edges()[candidate.tool];
    if (!is_apart(candidate, std::array{edge.from, edge.to})) edge_through_edge(candidate);
  }
  return part_;
}

const FeaturePassing::Ends& FeaturePassing::ends(std::uint32_t tool_vertex) noexcept {
  Ends& ends = ends_[tool_vertex];
  if (ends.step == steps_) return ends;
  const Vec3& p_T = tool_->vertices()[tool_vertex];
  ends = {R_from_ * p_T + X_from_.p, R_to_ * p_T + X_to_.p, steps_};
  return ends;
}

// Whether the candidate's plane separates its two features all along the step.
bool FeaturePassing::is_apart(const FeatureCandidate& candidate,
                              std::span<const std::uint32_t> tool) noexcept {
  const Vec3 away(candidate.away[0], candidate.away[1], candidate.away[2]);
  double least = std::numeric_limits<double>::infinity();
  for (const std::uint32_t vertex : tool) {
    const Ends& of_vertex = ends(vertex);
    least = std::min({least, away.dot(of_vertex.from_W), away.dot(of_vertex.to_W)});
  }
  return least > candidate.beyond;
}

// The two are in by in_ at that part of the step, and at its end by more than depth_.
void FeaturePassing::stop(double at, double gap_after) noexcept {
  part_ = std::min(part_, at + (1 - at) * (depth_ - in_) / (-gap_after - in_));
}

void FeaturePassing::vertex_through_face(const FeatureCandidate& candidate) noexcept {
  const std::span<const Vec3> scene = scene_->vertices();
  const FeatureMesh::Face& face = scene_->faces()[candidate.scene];
  const Vec3 &a = scene[face.corners[0]], &b = scene[face.corners[1]], &c = scene[face.corners[2]];
  const Ends& vertex = ends(candidate.tool);
  const double height = face.nhat.dot(vertex.from_W - a), height_after = face.nhat.dot(vertex.to_W - a);
  if (!(height >= -in_ && height_after < -depth_)) return;
  const double at = (height + in_) / (height - height_after);
  if (at >= part_) return;
  const Vec3 p = vertex.from_W + at * (vertex.to_W - vertex.from_W);
  if (is_on_face(p, a, b, c, in_)) stop(at, height_after);
}

// Seen from the tool it is the vertex that moves.
void FeaturePassing::face_over_vertex(const FeatureCandidate& candidate) noexcept {
  const std::span<const Vec3> tool = tool_->vertices();
  const FeatureMesh::Face& face = tool_->faces()[candidate.tool];
  const Vec3 &a = tool[face.corners[0]], &b = tool[face.corners[1]], &c = tool[face.corners[2]];
  const Vec3& p_W = scene_->vertices()[candidate.scene];
  const Vec3 from_T = R_from_.transpose() * (p_W - X_from_.p), to_T = R_to_.transpose() * (p_W - X_to_.p);
  const double height = face.nhat.dot(from_T - a), height_after = face.nhat.dot(to_T - a);
  if (!(height >= -in_ && height_after < -depth_)) return;
  const double at = (height + in_) / (height - height_after);
  if (at >= part_) return;
  const Vec3 p_T = from_T + at * (to_T - from_T);
  if (is_on_face(p_T, a, b, c, in_)) stop(at, height_after);
}

// The volume that the two edges span is a parabola in time, and changes its sign where their lines meet.
void FeaturePassing::edge_through_edge(const FeatureCandidate& candidate) noexcept {
  const std::span<const Vec3> scene = scene_->vertices();
  const FeatureMesh::Edge &of_tool = tool_->edges()[candidate.tool],
                          &of_scene = scene_->edges()[candidate.scene];
  const Ends &a = ends(of_tool.from), &b = ends(of_tool.to);
  const Vec3 &c = scene[of_scene.from], v = scene[of_scene.to] - c;
  const Vec3 u_from = b.from_W - a.from_W, u_to = b.to_W - a.to_W;
  const Vec3 across_from = u_from.cross(v), across_to = u_to.cross(v);
  // Outwards of the scene.
  const double sign = across_from.dot(scene_->edge_normals()[candidate.scene].axis()) < 0 ? -1 : 1;
  const double begin = sign * across_from.dot(a.from_W - c), end = sign * across_to.dot(a.to_W - c);
  const double length_from = across_from.norm(), length_to = across_to.norm();
  if (!(begin >= -in_ * length_from && end < -depth_ * length_to)) return;
  const double middle = sign * 0.25 * (across_from + across_to).dot(a.from_W + a.to_W - 2 * c);
  const double at =
      root_of_parabola(begin + in_ * length_from, middle + in_ * 0.5 * (across_from + across_to).norm(),
                       end + in_ * length_to);
  if (at >= part_) return;
  const Vec3 u = u_from + at * (u_to - u_from), w = a.from_W + at * (a.to_W - a.from_W) - c;
  const Vec3 across = u.cross(v);
  const double squared = across.squaredNorm();
  if (!(squared > kNearlyParallel * u.squaredNorm() * v.squaredNorm())) return;
  // Along either, where they meet.
  const double s = v.cross(w).dot(across) / squared, t = u.cross(w).dot(across) / squared;
  if (!(std::min(s, t) >= -kOnLine && std::max(s, t) <= 1 + kOnLine)) return;
  const Vec3 nhat = across * (sign / std::sqrt(squared));
  if (is_beside(of_scene.across, nhat, -1, slack_) &&
      is_beside(of_tool.across, R_from_.transpose() * nhat, 1, slack_))
    stop(at, end / length_to);
}

std::size_t FeaturePassing::bytes() const {
  return ends_.size() * sizeof(Ends);
}

}  // namespace fulcrum
