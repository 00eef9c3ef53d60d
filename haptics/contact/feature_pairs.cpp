#include "haptics/contact/feature_pairs.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fulcrum {
namespace {

constexpr double kLevel = 1e-9;      // m, what lies this far beyond a plane lies on it
constexpr double kParallel = 1e-12;  // squared sine of the angle between edges
constexpr double kNoSlack = 1e-6;    // rad, of rounding
constexpr double kAllAtOnce = 2e-6;  // m, deeper than it can have come
constexpr double kShortWay = 25e-6;  // m, of a place between two looks: what is near on its way was a pair
constexpr std::size_t kMostDeep = 256;
enum Kind : std::uint64_t { kVertexFace, kVertexEdge, kVertexVertex, kFaceVertex, kEdgeVertex, kEdgeEdge };

struct ClosestOfEdges {
  double s = 0, t = 0;  // along either, 0 to 1 between its ends
};

// Of two lines that are not parallel.
ClosestOfEdges closest_of_edges(const Vec3& a0, const Vec3& u, const Vec3& b0, const Vec3& v) {
  const Vec3 w = a0 - b0;
  const double a = u.dot(u), b = u.dot(v), c = v.dot(v), d = u.dot(w), e = v.dot(w);
  const double determinant = a * c - b * b;
  return {(b * e - c * d) / determinant, (a * e - b * d) / determinant};
}

// m, from the one segment to the other where an end of one is nearest to the other.
Vec3 between_ends(const Vec3& a0, const Vec3& u, const Vec3& b0, const Vec3& v) {
  const auto from_end = [](const Vec3& p, const Vec3& from, const Vec3& along) -> Vec3 {
    return p - from - std::clamp((p - from).dot(along) / along.squaredNorm(), 0.0, 1.0) * along;
  };
  Vec3 nearest = from_end(a0, b0, v);
  for (const Vec3& other :
       {from_end(a0 + u, b0, v), Vec3(-from_end(b0, a0, u)), Vec3(-from_end(b0 + v, a0, u))})
    if (other.squaredNorm() < nearest.squaredNorm()) nearest = other;
  return nearest;
}

// Whether a point at that height is above or below the face, or beyond it where the surface rises.
bool is_on(const FeatureMesh::Face& face, const TrianglePoint& closest, double height) {
  if (closest.feature == TriangleFeature::face) return true;
  const auto which = static_cast<unsigned>(closest.feature);
  const bool rises =
      which < 3 ? (face.rises_at_edges >> which & 1u) != 0 : (face.rises_at_corners >> (which - 3) & 1u) != 0;
  return rises && closest.squared - height * height <= FeaturePairs::kDeepest * FeaturePairs::kDeepest;
}

// Whether the place lies on the edge, or on its line where that goes on. Parts of one edge overlap by kFlat,
// so that none comes through between them.
bool is_on(const FeatureMesh::Edge& edge, double part, double length) {
  const double before = -part * length, beyond = (part - 1) * length;
  return before <= ((edge.goes_on & 1u) != 0 ? FeaturePairs::kDeepest : FeatureMesh::kFlat) &&
         beyond <= ((edge.goes_on & 2u) != 0 ? FeaturePairs::kDeepest : FeatureMesh::kFlat);
}

// Whether what lies that way of a vertex or an edge (unit directions) is on one side of the plane across nhat
// through it, but for `slack` rad: above it (sign 1), or below (-1).
bool on_side(std::span<const Vec3> ways, const Vec3& nhat, double sign, double slack) {
  for (const Vec3& way : ways)
    if (sign * nhat.dot(way) < -slack) return false;
  return true;
}

}  // namespace

FeaturePairs::FeaturePairs(std::shared_ptr<const FeatureMesh> tool_T,
                           std::shared_ptr<const FeatureMesh> scene_W)
    : tool_(std::move(tool_T)),
      scene_(std::move(scene_W)),
      places_(tool_->vertices().size()),
      lookahead_(*tool_, *scene_, kMostTurn, kDeepest),
      passing_(tool_, scene_, kMostTurn) {
  // The memory is there before the first tick.
  pairs_.resize(kMostPairs);
  pairs_.clear();
  deep_.reserve(kMostDeep);
  deep_before_.reserve(kMostDeep);
}

bool FeaturePairs::look(const Pose& X_WT, const Vec6& ahead, double reach, double farthest) noexcept {
  begin_depths();
  ++looks_;
  pairs_.clear();
  least_gap_ = std::numeric_limits<double>::infinity();
  // A point that turns goes along an arc, which is this much off its chord.
  const double bow = ahead.tail<3>().squaredNorm() * tool_->radius() / 8;
  const FeatureLookahead::Known known = lookahead_.look(X_WT, ahead, reach + bow, farthest + bow);
  complete_ = known.reach >= 0;
  ahead_ = known.reach > bow ? Vec6(known.part * ahead) : Vec6::Zero();
  near_ = known.reach;
  reach_ = std::max(0.0, ahead_.isZero() ? near_ : near_ - bow);
  const ToolWay way{.X_WT = X_WT, .step = ahead_};
  X_WT_ = X_WT;
  R_WT_ = X_WT.q.toRotationMatrix();
  X_WT_ahead_ = way.at(1);
  R_WT_ahead_ = X_WT_ahead_.q.toRotationMatrix();
  if (!complete_) return false;
  const ToolWay::Place &now = lookahead_.now(), &then = lookahead_.then();
  for (FeatureCandidate& candidate : lookahead_.gathering().candidates(FeatureGathering::kVertexFace))
    if (!candidate.is_apart(now, then, near_) && !is_apart(candidate, {&candidate.tool, 1}))
      vertex_on_face(candidate);
  for (FeatureCandidate& candidate : lookahead_.gathering().candidates(FeatureGathering::kFaceVertex))
    if (!candidate.is_apart(now, then, near_) && !is_apart(candidate, tool_->faces()[candidate.tool].corners))
      face_on_vertex(candidate);
  for (FeatureCandidate& candidate : lookahead_.gathering().candidates(FeatureGathering::kEdgeEdge)) {
    if (candidate.is_apart(now, then, near_)) continue;
    const FeatureMesh::Edge& edge = tool_->edges()[candidate.tool];
    if (!is_apart(candidate, std::array{edge.from, edge.to})) edge_on_edge(candidate);
  }
  lookahead_.go_on();
  return complete_;
}

void FeaturePairs::begin_depths() noexcept {
  if (complete_ && !taken_back_) {
    std::swap(deep_, deep_before_);
    X_WT_before_ = X_WT_;
    least_gap_before_ = looks_ == 0 ? -std::numeric_limits<double>::infinity() : std::min(0.0, least_gap_);
  }
  taken_back_ = false;
  deep_.clear();
}

// Whether the pair was no deeper at the last complete look than what was in then. After a longer way it may
// have gone past whatever it came in through, and counts as such; so does everything once there is no room.
bool FeaturePairs::came_from_outside(std::uint64_t key, const Vec3& p_W, const Vec3& nhat_W,
                                     double gap) noexcept {
  if (gap > -kAllAtOnce || deep_.size() == kMostDeep) return true;
  const auto before = std::find_if(deep_before_.begin(), deep_before_.end(),
                                   [&](const Deep& deep) { return deep.key == key; });
  bool came = false;
  if (before != deep_before_.end()) {
    came = before->came_from_outside;
  } else {
    const Vec3 before_W = X_WT_before_.q * (R_WT_.transpose() * (p_W - X_WT_.p)) + X_WT_before_.p;
    const Vec3 moved_W = p_W - before_W;
    came = moved_W.norm() > kShortWay || gap - nhat_W.dot(moved_W) >= least_gap_before_ - kAllAtOnce;
  }
  deep_.push_back({key, came});
  return came;
}

bool FeaturePairs::none_near() const {
  return complete_ && lookahead_.gathering().candidates(FeatureGathering::kVertexFace).empty() &&
         lookahead_.gathering().candidates(FeatureGathering::kFaceVertex).empty() &&
         lookahead_.gathering().candidates(FeatureGathering::kEdgeEdge).empty();
}

double FeaturePairs::free_part(const Pose& X_WT, double depth) noexcept {
  if (!lookahead_.gathering().is_done()) return 1;
  const double in = std::max(0.0, -least_gap_);
  return passing_.free_part(lookahead_.gathering(), X_WT_, X_WT, in, std::max(depth, in + kAllAtOnce));
}

const FeaturePairs::Place& FeaturePairs::place(std::uint32_t tool_vertex) noexcept {
  Place& place = places_[tool_vertex];
  if (place.look == looks_) return place;
  const Vec3& p_T = tool_->vertices()[tool_vertex];
  place = {R_WT_ * p_T + X_WT_.p, R_WT_ahead_ * p_T + X_WT_ahead_.p, looks_};
  return place;
}

bool FeaturePairs::is_apart(const FeatureCandidate& candidate, std::span<const std::uint32_t> tool) noexcept {
  ++measured_;
  const Vec3 away(candidate.away[0], candidate.away[1], candidate.away[2]);
  double least = std::numeric_limits<double>::infinity();
  for (const std::uint32_t vertex : tool) {
    const Place& of_vertex = place(vertex);
    least = std::min({least, away.dot(of_vertex.now_W), away.dot(of_vertex.ahead_W)});
  }
  return least - candidate.beyond > near_;
}

void FeaturePairs::add(std::uint64_t kind, std::uint32_t tool, std::uint32_t scene, const Vec3& p_W,
                       const Vec3& nhat_W, double gap) noexcept {
  if (pairs_.size() == kMostPairs) {
    complete_ = false;
    return;
  }
  const std::uint64_t key = kind << 60 | std::uint64_t{tool} << 30 | scene;
  if (!came_from_outside(key, p_W, nhat_W, gap)) return;
  pairs_.push_back({key, p_W, nhat_W, gap});
  least_gap_ = std::min(least_gap_, gap);
}

void FeaturePairs::vertex_on_face(FeatureCandidate& candidate) noexcept {
  const std::span<const Vec3> scene = scene_->vertices();
  const FeatureMesh::Face& face = scene_->faces()[candidate.scene];
  const std::span<const std::uint32_t> tool{&candidate.tool, 1};
  const Place& vertex = place(candidate.tool);
  const Vec3 &p = vertex.now_W, &a = scene[face.corners[0]], &b = scene[face.corners[1]],
             &c = scene[face.corners[2]];
  const double height = face.nhat.dot(p - a), height_ahead = face.nhat.dot(vertex.ahead_W - a);
  if (is_above(height, height_ahead))
    return lookahead_.gathering().set_apart(candidate, tool, face.nhat, {a, b, c}, 0);
  if (is_below(height, height_ahead))
    return lookahead_.gathering().set_apart(candidate, tool, -face.nhat, {a, b, c}, kDeepest);
  const TrianglePoint closest = closest_on_triangle(p, a, b, c);
  const double distance = std::sqrt(closest.squared);
  const Vec3 from_closest = distance > kLevel ? Vec3((p - closest.point) / distance) : face.nhat;
  // A vertex beyond the face's rim may be a pair with it only if the surface rises there.
  if (closest.feature != TriangleFeature::face) {
    const double allowance = face.rises_at_edges != 0 || face.rises_at_corners != 0 ? 2 * kDeepest : 0;
    if (is_above(distance - allowance, distance - allowance + from_closest.dot(vertex.ahead_W - p)))
      return lookahead_.gathering().set_apart(candidate, tool, from_closest, {a, b, c}, allowance);
  }
  const auto which = static_cast<unsigned>(closest.feature);
  const bool on_face = is_on(face, closest, height);
  const Vec3& nhat = on_face ? face.nhat : from_closest;
  if (!on_side(tool_->around(candidate.tool), R_WT_.transpose() * nhat, 1, kMostTurn)) return;
  if (on_face) {
    if (height >= -kDeepest) add(kVertexFace, candidate.tool, candidate.scene, p, nhat, height);
    return;
  }
  if (is_above(distance, distance + nhat.dot(vertex.ahead_W - p))) return;
  if (which < 3) {
    const FeatureMesh::Edge& edge = scene_->edges()[face.edges[which]];
    if ((face.own_edges >> which & 1u) != 0 && (edge.convex || edge.flat) &&
        on_side(edge.across, nhat, -1, kNoSlack))
      add(kVertexEdge, candidate.tool, face.edges[which], p, nhat, distance);
  } else {
    const std::uint32_t corner = face.corners[which - 3];
    if ((face.own_corners >> (which - 3) & 1u) != 0 && on_side(scene_->around(corner), nhat, -1, kNoSlack))
      add(kVertexVertex, candidate.tool, corner, p, nhat, distance);
  }
}

void FeaturePairs::face_on_vertex(FeatureCandidate& candidate) noexcept {
  const FeatureMesh::Face& face = tool_->faces()[candidate.tool];
  const Vec3& p = scene_->vertices()[candidate.scene];
  const Place &a = place(face.corners[0]), &b = place(face.corners[1]), &c = place(face.corners[2]);
  const std::span<const std::uint32_t> tool = face.corners;
  const Vec3 face_nhat = R_WT_ * face.nhat;
  const double height = face_nhat.dot(p - a.now_W),
               height_ahead = (R_WT_ahead_ * face.nhat).dot(p - a.ahead_W);
  if (is_above(height, height_ahead))
    return lookahead_.gathering().set_apart(candidate, tool, -face_nhat, {p}, 0);
  if (is_below(height, height_ahead))
    return lookahead_.gathering().set_apart(candidate, tool, face_nhat, {p}, kDeepest);
  const TrianglePoint closest = closest_on_triangle(p, a.now_W, b.now_W, c.now_W);
  const double distance = std::sqrt(closest.squared);
  const Vec3 to_closest = distance > kLevel ? Vec3((closest.point - p) / distance) : Vec3(-face_nhat);
  const double ahead =
      distance + std::min({to_closest.dot(a.ahead_W - a.now_W), to_closest.dot(b.ahead_W - b.now_W),
                           to_closest.dot(c.ahead_W - c.now_W)});
  if (closest.feature != TriangleFeature::face) {
    const double allowance = face.rises_at_edges != 0 || face.rises_at_corners != 0 ? 2 * kDeepest : 0;
    if (is_above(distance - allowance, ahead - allowance))
      return lookahead_.gathering().set_apart(candidate, tool, to_closest, {p}, allowance);
  }
  const auto which = static_cast<unsigned>(closest.feature);
  const bool on_face = is_on(face, closest, height);
  if (which >= 3 && !on_face) return;  // vertex on vertex: found from there
  const Vec3 nhat = on_face ? Vec3(-face_nhat) : to_closest;
  if (!on_side(scene_->around(candidate.scene), nhat, -1, kMostTurn)) return;
  if (on_face) {
    if (height >= -kDeepest) add(kFaceVertex, candidate.tool, candidate.scene, closest.point, nhat, height);
    return;
  }
  if (is_above(distance, ahead)) return;
  const FeatureMesh::Edge& edge = tool_->edges()[face.edges[which]];
  if ((face.own_edges >> which & 1u) != 0 && (edge.convex || edge.flat) &&
      on_side(edge.across, R_WT_.transpose() * nhat, 1, kNoSlack))
    add(kEdgeVertex, face.edges[which], candidate.scene, closest.point, nhat, distance);
}

void FeaturePairs::edge_on_edge(FeatureCandidate& candidate) noexcept {
  const std::span<const Vec3> scene = scene_->vertices();
  const FeatureMesh::Edge &of_tool = tool_->edges()[candidate.tool],
                          &of_scene = scene_->edges()[candidate.scene];
  const std::array tool{of_tool.from, of_tool.to};
  const Place &from = place(of_tool.from), &to = place(of_tool.to);
  const Vec3 &a0 = from.now_W, &b0 = scene[of_scene.from], &b1 = scene[of_scene.to];
  const Vec3 u = to.now_W - a0, v = b1 - b0;
  const Vec3 across = u.cross(v);
  const double squared = across.squaredNorm();
  if (squared > kParallel * u.squaredNorm() * v.squaredNorm()) {
    // Outwards of the scene.
    Vec3 nhat = across / std::sqrt(squared);
    if (nhat.dot(scene_->edge_normals()[candidate.scene].axis()) < 0) nhat = -nhat;
    const double gap = nhat.dot(a0 - b0);
    const double from_ahead = gap + nhat.dot(from.ahead_W - a0),
                 to_ahead = gap + nhat.dot(to.ahead_W - to.now_W);
    if (is_above(gap, std::min(from_ahead, to_ahead)))
      return lookahead_.gathering().set_apart(candidate, tool, nhat, {b0, b1}, 0);
    if (is_below(gap, std::max(from_ahead, to_ahead)))
      return lookahead_.gathering().set_apart(candidate, tool, -nhat, {b0, b1}, kDeepest);
    const ClosestOfEdges closest = closest_of_edges(a0, u, b0, v);
    if (is_on(of_tool, closest.s, u.norm()) && is_on(of_scene, closest.t, v.norm())) {
      if (gap >= -kDeepest && on_side(of_scene.across, nhat, -1, kMostTurn) &&
          on_side(of_tool.across, R_WT_.transpose() * nhat, 1, kMostTurn))
        add(kEdgeEdge, candidate.tool, candidate.scene, a0 + closest.s * u, nhat, gap);
      return;
    }
  }
  // Their ends tell of them. Lines that go on do so for kDeepest.
  const Vec3 apart = between_ends(a0, u, b0, v);
  const double distance = apart.norm();
  if (distance > kLevel)
    lookahead_.gathering().set_apart(candidate, tool, apart / distance, {b0, b1}, kDeepest);
}

std::size_t FeaturePairs::bytes() const {
  return tool_->bytes() + scene_->bytes() + lookahead_.bytes() + passing_.bytes() +
         places_.size() * sizeof(Place) + kMostPairs * sizeof(FeaturePair);
}

}  // namespace fulcrum
