#include "haptics/contact/feature_gathering.h"

#include <cmath>
#include <limits>

#include "haptics/geometry/bounds-inl.h"
#include "haptics/math/rotation.h"

namespace fulcrum {
namespace {

constexpr double kGatheringError = 1e-9;  // m and rad
constexpr double kAlmostParallel = 0.2;   // sine of the angle between two edges
constexpr double kAboveFirstOrder = 1.1;  // how much faster than in the limit of small turns
constexpr float kMuchLarger = 2;          // of two boxes, so that it alone is divided
constexpr std::size_t kDepth = 1u << 10;  // of what waits: 15 of each level of both trees

// A face's own normal, or one of its edges' or corners'.
template <class IsOpposed>
bool any_normal(const FeatureMesh& mesh, const FeatureMesh::Face& face, bool corners,
                const IsOpposed& is_opposed) {
  if (is_opposed(NormalCone(face.nhat))) return true;
  for (unsigned i = 0; i < 3; ++i) {
    const FeatureMesh::Edge& edge = mesh.edges()[face.edges[i]];
    if ((face.own_edges >> i & 1u) != 0 && (edge.convex || edge.flat) &&
        is_opposed(mesh.edge_normals()[face.edges[i]]))
      return true;
    const NormalCone& corner = mesh.vertex_normals()[face.corners[i]];
    if (corners && (face.own_corners >> i & 1u) != 0 && !corner.none() && is_opposed(corner)) return true;
  }
  return false;
}

}  // namespace

Pose ToolWay::at(double part) const noexcept {
  return {(quaternion_exp(part * step.tail<3>()) * X_WT.q).normalized(), X_WT.p + part * step.head<3>()};
}

ToolWay::Place ToolWay::place(const Pose& pose, double radius) const noexcept {
  const double arm = radius * radius;
  const auto v = step.head<3>(), w = step.tail<3>();
  const double squared = v.squaredNorm() + arm * w.squaredNorm();
  Place result;
  if (squared > 0) {
    const Vec3 turned = rotation_vector(pose.q * X_WT.q.conjugate());
    result.part = std::clamp((v.dot(pose.p - X_WT.p) + arm * w.dot(turned)) / squared, 0.0, 1.0);
  }
  const Pose nearest = at(result.part);
  result.off = (pose.p - nearest.p).norm() + kGatheringError;
  result.turn_off = angle_between(pose.q, nearest.q) + kGatheringError;
  return result;
}

FeatureGathering::FeatureGathering(const FeatureMesh& tool_T, const FeatureMesh& scene_W, double slack,
                                   double deepest)
    : tool_(&tool_T),
      scene_(&scene_W),
      slack_(slack),
      deepest_(deepest),
      posed_{Posed(tool_T.vertex_tree()), Posed(tool_T.face_tree()), Posed(tool_T.edge_tree())},
      ends_(tool_T.vertices().size()) {
  // The memory is there before the first tick.
  for (std::vector<FeatureCandidate>& candidates : candidates_) {
    candidates.resize(kMostCandidates);
    candidates.clear();
  }
  meetings_.reserve(kDepth);
  for (std::size_t v = 0; v < ends_.size(); ++v)
    ends_[v].radius = std::nextafter(static_cast<float>(tool_->vertices()[v].norm()), 1e9F);
}

FeatureGathering::Posed::Posed(const FeatureTree& tree)
    : groups(tree.groups()), gathering(groups.size()), bounds_W(groups.size()) {}

const FeatureTree& FeatureGathering::scene_tree(Kind kind) const {
  return kind == kVertexFace ? scene_->face_tree()
                             : (kind == kFaceVertex ? scene_->vertex_tree() : scene_->edge_tree());
}

void FeatureGathering::begin(const ToolWay& way, std::size_t most, std::size_t most_visits) noexcept {
  way_ = way;
  const Pose to = way.at(1);
  const double turn = way.step.tail<3>().norm();
  sweep_ = {.R_from = way.X_WT.q.toRotationMatrix(),
            .R_middle = way.at(0.5).q.toRotationMatrix(),
            .R_to = to.q.toRotationMatrix(),
            .p_from = way.X_WT.p,
            .p_to = to.p,
            .reach = way.reach,
            .turn = way.turn + turn * turn / 8,  // so far off its chord is an arc
            .slack = {}};
  turned_ = way.turn + 0.5 * turn;
  most_ = std::min(most, kMostCandidates);
  most_visits_ = most_visits;
  visits_ = 0;
  too_many_ = false;
  ++gathering_;
  meetings_.clear();
  for (std::vector<FeatureCandidate>& candidates : candidates_) candidates.clear();
  kind_ = 0;
  state_ = State::going_on;
  begin_kind();
}

void FeatureGathering::begin_kind() noexcept {
  Posed& tool = posed_[kind_];
  const std::span<const FeatureTree::Group> scene = scene_tree(static_cast<Kind>(kind_)).groups();
  if (tool.groups.empty() || scene.empty()) return;
  // Both edges of a pair may be off by the slack.
  cone_ = NormalCone(Vec3::UnitX(), (kind_ == kEdgeEdge ? 2 : 1) * slack_ + turned_);
  sweep_.slack = cone_;
  meetings_.push_back({});
}

void FeatureGathering::go_on(std::size_t visits) noexcept {
  const std::size_t last = visits_ + std::min(visits, kAnyNumber - visits_);
  while (state_ == State::going_on && visits_ < last) {
    if (meetings_.empty()) {
      if (++kind_ == kKinds)
        state_ = State::done;
      else
        begin_kind();
      continue;
    }
    const Meeting meeting = meetings_.back();
    meetings_.pop_back();
    descend(meeting);
    if (too_many_ || visits_ > most_visits_) state_ = State::none;
  }
}

void FeatureGathering::descend(const Meeting& meeting) noexcept {
  ++visits_;
  const Bounds4& tool_W = pose(posed_[kind_], meeting.tool);
  const Bounds4& scene_W = scene_tree(static_cast<Kind>(kind_)).groups()[meeting.scene].bounds;
  unsigned meets = scene_W.meeting(tool_W);
  if (meeting.tool_lane != Meeting::kAll) meets &= 0xFU << 4 * meeting.tool_lane;
  if (meeting.scene_lane != Meeting::kAll) meets &= 0x1111U << meeting.scene_lane;
  for (; meets != 0; meets &= meets - 1) {
    const unsigned bit = lowest_bit(meets);
    meet({meeting.tool, meeting.scene, bit / 4, bit % 4});
  }
}

// Two lanes that meet: two features, or what is below both of them, or below the larger one.
void FeatureGathering::meet(const Meeting& lanes) noexcept {
  const FeatureTree::Group &tool = posed_[kind_].groups[lanes.tool],
                           &scene = scene_tree(static_cast<Kind>(kind_)).groups()[lanes.scene];
  const std::uint32_t tool_child = tool.children[lanes.tool_lane],
                      scene_child = scene.children[lanes.scene_lane];
  const bool tool_ends = (tool_child & FeatureTree::kFeature) != 0,
             scene_ends = (scene_child & FeatureTree::kFeature) != 0;
  if (tool_ends && scene_ends)
    return take(tool_child ^ FeatureTree::kFeature, scene_child ^ FeatureTree::kFeature);
  const float tool_size = tool.bounds.size(lanes.tool_lane), scene_size = scene.bounds.size(lanes.scene_lane);
  if (tool_ends || (!scene_ends && scene_size > kMuchLarger * tool_size))
    meetings_.push_back({lanes.tool, scene_child, lanes.tool_lane, Meeting::kAll});
  else if (scene_ends || tool_size > kMuchLarger * scene_size)
    meetings_.push_back({tool_child, lanes.scene, Meeting::kAll, lanes.scene_lane});
  else
    meetings_.push_back({tool_child, scene_child});
}

const Bounds4& FeatureGathering::pose(Posed& tool, std::uint32_t group) noexcept {
  Bounds4& bounds_W = tool.bounds_W[group];
  if (tool.gathering[group] == gathering_) return bounds_W;
  tool.gathering[group] = gathering_;
  bounds_W = tool.groups[group].bounds.swept(sweep_);
  return bounds_W;
}

const FeatureGathering::Ends& FeatureGathering::ends(std::uint32_t tool_vertex) noexcept {
  Ends& ends = ends_[tool_vertex];
  if (ends.gathering == gathering_) return ends;
  const Vec3& p_T = tool_->vertices()[tool_vertex];
  ends.from_W = sweep_.R_from * p_T + sweep_.p_from;
  ends.to_W = sweep_.R_to * p_T + sweep_.p_to;
  ends.gathering = gathering_;
  return ends;
}

void FeatureGathering::set_apart(FeatureCandidate& candidate, std::span<const std::uint32_t> tool,
                                 const Vec3& away, std::initializer_list<Vec3> scene,
                                 double allowance) noexcept {
  const Eigen::Vector3f narrow = away.cast<float>();
  const Vec3 wide = narrow.cast<double>();
  candidate.away = {narrow.x(), narrow.y(), narrow.z()};
  candidate.beyond = -std::numeric_limits<double>::infinity();
  for (const Vec3& p_W : scene) candidate.beyond = std::max(candidate.beyond, wide.dot(p_W) + allowance);
  double from = std::numeric_limits<double>::infinity(), to = from;
  for (const std::uint32_t vertex : tool) {
    const Ends& of_vertex = ends(vertex);
    from = std::min(from, wide.dot(of_vertex.from_W));
    to = std::min(to, wide.dot(of_vertex.to_W));
  }
  // Between its ends an arc comes nearer than its chord.
  const double bow = candidate.radius * way_.step.tail<3>().squaredNorm() / 8 + kGatheringError;
  candidate.apart = static_cast<float>(from - candidate.beyond - bow);
  candidate.apart_way = static_cast<float>(to - from);
}

bool FeatureGathering::is_out(const FeatureCandidate& candidate) const noexcept {
  return candidate.apart + std::min(candidate.apart_way, 0.0F) > way_.reach + candidate.radius * way_.turn;
}

void FeatureGathering::keep(const FeatureCandidate& candidate) noexcept {
  std::vector<FeatureCandidate>& candidates = candidates_[kind_];
  if (candidates.size() == most_)
    too_many_ = true;
  else
    candidates.push_back(candidate);
}

void FeatureGathering::take(std::uint32_t tool, std::uint32_t scene) noexcept {
  if (kind_ == kVertexFace)
    take_vertex_face(tool, scene);
  else if (kind_ == kFaceVertex)
    take_face_vertex(tool, scene);
  else
    take_edges(tool, scene);
}

// Whether a plane across nhat is between the two all along the way, on either side; else the candidate has
// one of them.
bool FeatureGathering::is_out(FeatureCandidate& candidate, std::span<const std::uint32_t> tool,
                              const Vec3& nhat, std::initializer_list<Vec3> scene) noexcept {
  for (const std::uint32_t vertex : tool) candidate.radius = std::max(candidate.radius, ends_[vertex].radius);
  set_apart(candidate, tool, nhat, scene, 0);
  if (is_out(candidate)) return true;
  if (candidate.apart > 0) return false;
  FeatureCandidate below = candidate;
  set_apart(below, tool, -nhat, scene, deepest_);
  if (is_out(below)) return true;
  if (below.apart > 0) candidate = below;
  return false;
}

void FeatureGathering::take_vertex_face(std::uint32_t vertex, std::uint32_t face) noexcept {
  const FeatureMesh::Face& of_scene = scene_->faces()[face];
  const std::span<const Vec3> p = scene_->vertices();
  FeatureCandidate candidate{.tool = vertex, .scene = face};
  if (is_out(candidate, {&vertex, 1}, of_scene.nhat,
             {p[of_scene.corners[0]], p[of_scene.corners[1]], p[of_scene.corners[2]]}))
    return;
  const NormalCone& of_vertex = tool_->vertex_normals()[vertex];
  const Vec3 axis_W = sweep_.R_middle * of_vertex.axis();
  if (any_normal(*scene_, of_scene, true,
                 [&](const NormalCone& cone) { return of_vertex.opposes(axis_W, cone, cone_); }))
    keep(candidate);
}

void FeatureGathering::take_face_vertex(std::uint32_t face, std::uint32_t vertex) noexcept {
  const FeatureMesh::Face& of_tool = tool_->faces()[face];
  FeatureCandidate candidate{.tool = face, .scene = vertex};
  if (is_out(candidate, of_tool.corners, -(sweep_.R_middle * of_tool.nhat), {scene_->vertices()[vertex]}))
    return;
  const NormalCone& of_vertex = scene_->vertex_normals()[vertex];
  const Vec3 axis_T = sweep_.R_middle.transpose() * of_vertex.axis();
  if (any_normal(*tool_, of_tool, false,
                 [&](const NormalCone& cone) { return of_vertex.opposes(axis_T, cone, cone_); }))
    keep(candidate);
}

// Two edges are no candidate if their common perpendicular is never a normal of both. That perpendicular
// turns faster than they do, and of edges that are almost parallel a lot faster.
void FeatureGathering::take_edges(std::uint32_t of_tool, std::uint32_t of_scene) noexcept {
  const FeatureMesh::Edge &a = tool_->edges()[of_tool], &b = scene_->edges()[of_scene];
  const Vec3 &b0 = scene_->vertices()[b.from], &b1 = scene_->vertices()[b.to];
  const std::array tool{a.from, a.to};
  const Vec3 u = sweep_.R_middle * (tool_->vertices()[a.to] - tool_->vertices()[a.from]), v = b1 - b0;
  const Vec3 across = u.cross(v);
  const double length = across.norm(), sine = length / std::sqrt(u.squaredNorm() * v.squaredNorm());
  if (sine < kAlmostParallel) {
    keep({.tool = of_tool, .scene = of_scene, .radius = std::max(ends_[a.from].radius, ends_[a.to].radius)});
    return;
  }
  const double slack = (slack_ + turned_ * (1 + kAboveFirstOrder / sine)) * length;
  const Vec3 across_T = sweep_.R_middle.transpose() * across;
  double above_scene = length, below_scene = length, above_tool = length, below_tool = length;
  for (unsigned i = 0; i < 2; ++i) {
    const double of_b = b.across[i].dot(across), of_a = a.across[i].dot(across_T);
    above_scene = std::min(above_scene, of_b);
    below_scene = std::min(below_scene, -of_b);
    above_tool = std::min(above_tool, of_a);
    below_tool = std::min(below_tool, -of_a);
  }
  const bool up = below_scene >= -slack && above_tool >= -slack,
             down = above_scene >= -slack && below_tool >= -slack;
  if (!up && !down) return;
  const bool outwards = across.dot(scene_->edge_normals()[of_scene].axis()) >= 0;
  FeatureCandidate candidate{.tool = of_tool, .scene = of_scene};
  if (!is_out(candidate, tool, across / (outwards ? length : -length), {b0, b1})) keep(candidate);
}

std::size_t FeatureGathering::bytes() const {
  std::size_t sum = ends_.size() * sizeof(Ends) + kDepth * sizeof(Meeting) +
                    kKinds * kMostCandidates * sizeof(FeatureCandidate);
  for (const Posed& tool : posed_) sum += tool.groups.size() * (sizeof(std::uint32_t) + sizeof(Bounds4));
  return sum;
}

}  // namespace fulcrum
