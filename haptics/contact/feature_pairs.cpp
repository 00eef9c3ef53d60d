#include "haptics/contact/feature_pairs.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "haptics/math/rotation.h"

namespace fulcrum {
namespace {

constexpr double kLevel = 1e-9;    // m, what lies this far beyond a plane lies on it
constexpr double kGathered = 1.5;  // over the reach of a look: how far off the candidates are gathered
constexpr double kLeastGathered = 100e-6;  // m, and at least
constexpr double kNoSlack = 1e-6;          // rad, of rounding
constexpr double kTurn = 0.02;  // rad, a tool that has turned farther has its candidates gathered anew
constexpr double kAlmostParallel = 0.2;   // sine of the angle between two edges
constexpr double kAboveFirstOrder = 1.1;  // how much faster than in the limit of small turns
enum Kind : std::uint64_t { kVertexFace, kVertexEdge, kVertexVertex, kFaceVertex, kEdgeVertex, kEdgeEdge };

struct ClosestOfEdges {
  double s = 0, t = 0;    // 0 to 1 along either
  bool crossing = false;  // no parallels, of which the ends tell
};

ClosestOfEdges closest_of_edges(const Vec3& a0, const Vec3& u, const Vec3& b0, const Vec3& v) {
  const Vec3 w = a0 - b0;
  const double a = u.dot(u), b = u.dot(v), c = v.dot(v), d = u.dot(w), e = v.dot(w);
  const double determinant = a * c - b * b;
  if (!(determinant > 1e-12 * a * c)) return {};
  return {(b * e - c * d) / determinant, (a * e - b * d) / determinant, true};
}

unsigned lowest_bit(unsigned bits) {
  return static_cast<unsigned>(std::countr_zero(bits));
}

// m^2: of the segments from a0 along u and from b0 along v, ends included.
double squared_distance_of_edges(const Vec3& a0, const Vec3& u, const Vec3& b0, const Vec3& v) {
  const ClosestOfEdges lines = closest_of_edges(a0, u, b0, v);
  if (lines.crossing && lines.s >= 0 && lines.s <= 1 && lines.t >= 0 && lines.t <= 1)
    return (a0 + lines.s * u - b0 - lines.t * v).squaredNorm();
  const auto of_end = [](const Vec3& p, const Vec3& from, const Vec3& along) {
    const double part = std::clamp((p - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
    return (p - from - part * along).squaredNorm();
  };
  return std::min(std::min(of_end(a0, b0, v), of_end(a0 + u, b0, v)),
                  std::min(of_end(b0, a0, u), of_end(b0 + v, a0, u)));
}

// Whether the segment goes through the triangle.
bool pierces(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& nhat) {
  const double from = nhat.dot(p - a), to = nhat.dot(q - a);
  if (!(from * to < 0)) return false;
  const Vec3 x = p + (q - p) * (from / (from - to));
  return nhat.dot((b - a).cross(x - a)) > 0 && nhat.dot((c - b).cross(x - b)) > 0 &&
         nhat.dot((a - c).cross(x - c)) > 0;
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
      tool_vertices_(tool_->vertex_tree()),
      tool_edges_(tool_->edge_tree()),
      tool_faces_(tool_->face_tree()) {
  for (std::vector<Candidate>* candidates : {&vertex_faces_, &face_vertices_, &edge_edges_})
    candidates->reserve(kMostCandidates);
  pairs_.reserve(kMostPairs);
}

bool FeaturePairs::look(const Pose& X_WT, double reach, std::size_t most) noexcept {
  odometer_ += way(X_WT_, X_WT);
  X_WT_ = X_WT;
  R_WT_ = X_WT.q.toRotationMatrix();
  reach_ = reach;
  most_ = std::min(most, kMostCandidates);
  complete_ = true;
  pairs_.clear();
  least_gap_ = std::numeric_limits<double>::infinity();
  // As long as what was gathered holds all that can have come within reach, or in.
  const bool holds = gathered_ && gathered_reach_ >= std::max(reach_, kDeepest) + way(X_WT_gathered_, X_WT) &&
                     angle_between(X_WT_gathered_.q, X_WT.q) < kTurn;
  if (!holds) {
    gathered_reach_ = std::max(kGathered * reach_, kLeastGathered);
    X_WT_gathered_ = X_WT;
    R_WT_gathered_ = R_WT_;
    gather();
    if (!complete_) {
      gathered_ = false;
      return false;
    }
  }
  const double due = odometer_ + reach_;
  for (Candidate& candidate : vertex_faces_)
    if (!(candidate.due > due)) vertex_on_face(candidate);
  for (Candidate& candidate : face_vertices_)
    if (!(candidate.due > due)) face_on_vertex(candidate);
  for (Candidate& candidate : edge_edges_)
    if (!(candidate.due > due)) edge_on_edge(candidate);
  if (!holds) {
    const double out = odometer_ + gathered_reach_;
    for (std::vector<Candidate>* candidates : {&vertex_faces_, &face_vertices_, &edge_edges_})
      std::erase_if(*candidates, [out](const Candidate& candidate) { return candidate.due > out; });
    gathered_ = complete_;
  }
  return complete_;
}

bool FeaturePairs::none_near() const {
  return complete_ && vertex_faces_.empty() && face_vertices_.empty() && edge_edges_.empty();
}

double FeaturePairs::way(const Pose& from, const Pose& to) const noexcept {
  return (to.p - from.p).norm() + angle_between(to.q, from.q) * tool_->radius() + kLevel;
}

void FeaturePairs::keep(std::vector<Candidate>& candidates, std::uint32_t tool,
                        std::uint32_t scene) noexcept {
  if (candidates.size() == most_)
    complete_ = false;
  else
    candidates.push_back({tool, scene, odometer_});
}

void FeaturePairs::gather() noexcept {
  vertex_faces_.clear();
  face_vertices_.clear();
  edge_edges_.clear();
  ++gathering_;
  const FeatureMesh &tool = *tool_, &scene = *scene_;
  // A face's own normal, or one of its edges' or corners'.
  const auto of_face = [&](const FeatureMesh& mesh, const FeatureMesh::Face& face, bool corners,
                           const auto& is_opposed) {
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
  };
  gather_kind(
      tool_vertices_, scene.face_tree(), kMostTurn + kTurn,
      [&](std::uint32_t v, std::uint32_t g) {
        const FeatureMesh::Face& face = scene.faces()[g];
        const NormalCone& of_vertex = tool.vertex_normals()[v];
        const Vec3 axis_W = R_WT_ * of_vertex.axis();
        if (!of_face(
                scene, face, true,
                [&](const NormalCone& cone) {
                  return of_vertex.opposes(axis_W, cone, tool_vertices_.slack);
                }))
          return;
        keep(vertex_faces_, v, g);
      });
  gather_kind(tool_faces_, scene.vertex_tree(), kMostTurn + kTurn, [&](std::uint32_t f, std::uint32_t v) {
    const FeatureMesh::Face& face = tool.faces()[f];
    const NormalCone& of_vertex = scene.vertex_normals()[v];
    const Vec3 axis_T = R_WT_.transpose() * of_vertex.axis();
    if (!of_face(tool, face, false,
                 [&](const NormalCone& cone) { return of_vertex.opposes(axis_T, cone, tool_faces_.slack); }))
      return;
    keep(face_vertices_, f, v);
  });
  // Both edges of a pair may be off by kMostTurn.
  gather_kind(tool_edges_, scene.edge_tree(), 2 * kMostTurn + kTurn, [&](std::uint32_t e, std::uint32_t k) {
    if (could_oppose(tool.edges()[e], scene.edges()[k])) keep(edge_edges_, e, k);
  });
}

// Whether the common perpendicular of two edges can be a normal of both before the tool has turned by kTurn.
// It turns faster than they do, and of edges that are almost parallel a lot faster.
bool FeaturePairs::could_oppose(const FeatureMesh::Edge& of_tool,
                                const FeatureMesh::Edge& of_scene) const noexcept {
  const Vec3 u = R_WT_ * (tool_->vertices()[of_tool.to] - tool_->vertices()[of_tool.from]);
  const Vec3 v = scene_->vertices()[of_scene.to] - scene_->vertices()[of_scene.from];
  const Vec3 across = u.cross(v);
  const double sine = std::sqrt(across.squaredNorm() / (u.squaredNorm() * v.squaredNorm()));
  if (sine < kAlmostParallel) return true;
  const Vec3 nhat = across.normalized();
  const double slack = kMostTurn + kTurn * (1 + kAboveFirstOrder / sine);
  const auto opposes = [&](double sign) {
    return on_side(of_scene.across, nhat, -sign, slack) &&
           on_side(of_tool.across, R_WT_.transpose() * nhat, sign, slack);
  };
  return opposes(1) || opposes(-1);
}

FeaturePairs::Posed::Posed(const FeatureTree& tree)
    : groups(tree.groups()), gathering(groups.size()), bounds_W(groups.size()) {}

const Bounds4& FeaturePairs::pose(Posed& tool, std::uint32_t group) noexcept {
  Bounds4& bounds_W = tool.bounds_W[group];
  if (tool.gathering[group] == gathering_) return bounds_W;
  tool.gathering[group] = gathering_;
  bounds_W = tool.groups[group].bounds.moved(R_WT_gathered_, X_WT_gathered_.p, gathered_reach_, tool.slack);
  return bounds_W;
}

template <class Take>
void FeaturePairs::gather_kind(Posed& tool, const FeatureTree& scene, double slack,
                               const Take& take) noexcept {
  if (tool.groups.empty() || scene.groups().empty()) return;
  tool.slack = NormalCone(Vec3::UnitX(), slack);
  const Bounds4& all = pose(tool, 0);
  for (unsigned i = 0; i < 4; ++i)
    for (unsigned meeting = scene.groups()[0].bounds.meeting(all[i]); meeting != 0; meeting &= meeting - 1)
      descend(tool, scene, {0, i}, {0, lowest_bit(meeting)}, take);
}

// Two lanes that meet.
template <class Take>
void FeaturePairs::descend(Posed& tool, const FeatureTree& scene, Lane of_tool, Lane of_scene,
                           const Take& take) noexcept {
  const std::uint32_t tool_child = tool.groups[of_tool.group].children[of_tool.lane],
                      scene_child = scene.groups()[of_scene.group].children[of_scene.lane];
  const bool tool_ends = (tool_child & FeatureTree::kFeature) != 0,
             scene_ends = (scene_child & FeatureTree::kFeature) != 0;
  if (tool_ends && scene_ends) {
    take(tool_child ^ FeatureTree::kFeature, scene_child ^ FeatureTree::kFeature);
    return;
  }
  const Bounds tool_W = tool.bounds_W[of_tool.group][of_tool.lane],
               scene_W = scene.groups()[of_scene.group].bounds[of_scene.lane];
  const bool splits_scene = tool_ends || (!scene_ends && scene_W.size() > tool_W.size());
  unsigned meeting = splits_scene ? scene.groups()[scene_child].bounds.meeting(tool_W)
                                  : pose(tool, tool_child).meeting(scene_W);
  for (; meeting != 0; meeting &= meeting - 1) {
    if (!complete_) return;
    const unsigned lane = lowest_bit(meeting);
    if (splits_scene)
      descend(tool, scene, of_tool, {scene_child, lane}, take);
    else
      descend(tool, scene, {tool_child, lane}, of_scene, take);
  }
}

void FeaturePairs::add(std::uint64_t kind, std::uint32_t tool, std::uint32_t scene, const Vec3& p_W,
                       const Vec3& nhat_W, double gap) noexcept {
  if (pairs_.size() == kMostPairs) {
    complete_ = false;
    return;
  }
  pairs_.push_back({kind << 60 | std::uint64_t{tool} << 30 | scene, p_W, nhat_W, gap});
  least_gap_ = std::min(least_gap_, gap);
}

double FeaturePairs::due(double gap) const noexcept {
  return odometer_ + std::max({gap, -gap - kDeepest, 0.0});
}

bool FeaturePairs::is_far(double gap) const noexcept {
  return gap > reach_ || gap < -std::max(reach_, kDeepest);
}

void FeaturePairs::vertex_on_face(Candidate& candidate) noexcept {
  const std::span<const Vec3> scene = scene_->vertices();
  const FeatureMesh::Face& face = scene_->faces()[candidate.scene];
  const Vec3 p = in_world(candidate.tool);
  const Vec3& corner = scene[face.corners[0]];
  const double height = face.nhat.dot(p - corner);
  candidate.due = due(height);
  if (is_far(height)) return;
  const TrianglePoint closest =
      closest_on_triangle(p, corner, scene[face.corners[1]], scene[face.corners[2]]);
  const double distance = std::sqrt(closest.squared);
  candidate.due = due(std::copysign(distance, height));
  if (is_far(std::copysign(distance, height))) return;
  const auto which = static_cast<unsigned>(closest.feature);
  const bool on_face = is_on(face, closest, height);
  const Vec3 nhat = on_face || !(distance > kLevel) ? face.nhat : Vec3((p - closest.point) / distance);
  if (!on_side(tool_->around(candidate.tool), R_WT_.transpose() * nhat, 1, kMostTurn)) return;
  if (on_face) {
    if (height >= -kDeepest) add(kVertexFace, candidate.tool, candidate.scene, p, nhat, height);
  } else if (which < 3) {
    const FeatureMesh::Edge& edge = scene_->edges()[face.edges[which]];
    if ((face.own_edges >> which & 1u) != 0 && (edge.convex || edge.flat) &&
        on_side(edge.across, nhat, -1, kNoSlack))
      add(kVertexEdge, candidate.tool, face.edges[which], p, nhat, distance);
  } else {
    const std::uint32_t vertex = face.corners[which - 3];
    if ((face.own_corners >> (which - 3) & 1u) != 0 && on_side(scene_->around(vertex), nhat, -1, kNoSlack))
      add(kVertexVertex, candidate.tool, vertex, p, nhat, distance);
  }
}

void FeaturePairs::face_on_vertex(Candidate& candidate) noexcept {
  const std::span<const Vec3> tool = tool_->vertices(), scene = scene_->vertices();
  const FeatureMesh::Face& face = tool_->faces()[candidate.tool];
  const Vec3& p_W = scene[candidate.scene];
  const Vec3 p = R_WT_.transpose() * (p_W - X_WT_.p);
  const Vec3& corner = tool[face.corners[0]];
  const double height = face.nhat.dot(p - corner);
  candidate.due = due(height);
  if (is_far(height)) return;
  const TrianglePoint closest = closest_on_triangle(p, corner, tool[face.corners[1]], tool[face.corners[2]]);
  const double distance = std::sqrt(closest.squared);
  candidate.due = due(std::copysign(distance, height));
  if (is_far(std::copysign(distance, height))) return;
  const auto which = static_cast<unsigned>(closest.feature);
  const bool on_face = is_on(face, closest, height);
  if (which >= 3 && !on_face) return;  // vertex on vertex: found from there
  const Vec3 nhat_T =
      on_face || !(distance > kLevel) ? Vec3(-face.nhat) : Vec3((closest.point - p) / distance);
  const Vec3 nhat_W = R_WT_ * nhat_T;
  if (!on_side(scene_->around(candidate.scene), nhat_W, -1, kMostTurn)) return;
  const Vec3 closest_W = R_WT_ * closest.point + X_WT_.p;
  if (on_face) {
    if (height >= -kDeepest) add(kFaceVertex, candidate.tool, candidate.scene, closest_W, nhat_W, height);
    return;
  }
  const FeatureMesh::Edge& edge = tool_->edges()[face.edges[which]];
  if ((face.own_edges >> which & 1u) != 0 && (edge.convex || edge.flat) &&
      on_side(edge.across, nhat_T, 1, kNoSlack))
    add(kEdgeVertex, face.edges[which], candidate.scene, closest_W, nhat_W, distance);
}

void FeaturePairs::edge_on_edge(Candidate& candidate) noexcept {
  const std::span<const Vec3> scene = scene_->vertices();
  const FeatureMesh::Edge &of_tool = tool_->edges()[candidate.tool],
                          &of_scene = scene_->edges()[candidate.scene];
  const Vec3 a0 = in_world(of_tool.from), &b0 = scene[of_scene.from];
  const Vec3 u = in_world(of_tool.to) - a0, v = scene[of_scene.to] - b0;
  const ClosestOfEdges closest = closest_of_edges(a0, u, b0, v);
  if (!closest.crossing || !is_on(of_tool, closest.s, u.norm()) || !is_on(of_scene, closest.t, v.norm())) {
    candidate.due = odometer_ + std::max(0.0, std::sqrt(squared_distance_of_edges(a0, u, b0, v)) - kDeepest);
    return;
  }
  const Vec3 p = a0 + closest.s * u, q = b0 + closest.t * v;
  // Outwards of the scene.
  Vec3 nhat = u.cross(v).normalized();
  if (nhat.dot(scene_->edge_normals()[candidate.scene].axis()) < 0) nhat = -nhat;
  const double gap = nhat.dot(p - q);
  candidate.due = due(gap);
  if (is_far(gap)) return;
  if (!on_side(of_scene.across, nhat, -1, kMostTurn) ||
      !on_side(of_tool.across, R_WT_.transpose() * nhat, 1, kMostTurn))
    return;
  if (gap >= -kDeepest) add(kEdgeEdge, candidate.tool, candidate.scene, p, nhat, gap);
}

bool FeaturePairs::crosses() noexcept {
  for (unsigned part = 0; part < kParts; ++part)
    if (crosses(part)) return true;
  return false;
}

bool FeaturePairs::crosses(unsigned part) noexcept {
  if (tool_faces_.groups.empty() || scene_->face_tree().groups().empty()) return false;
  // Three levels down the tool's tree: to the lane that the part's digits say. Where a branch is shorter, the
  // rest of its digits are 0.
  Lane of_tool{0, part / 16 % 4};
  pose(tool_faces_, 0);
  for (const unsigned digit : {part / 4 % 4, part % 4}) {
    const std::uint32_t child = tool_faces_.groups[of_tool.group].children[of_tool.lane];
    if (child == FeatureTree::kNone) return false;
    if ((child & FeatureTree::kFeature) == 0) {
      of_tool = {child, digit};
      pose(tool_faces_, child);
    } else if (digit != 0) {
      return false;
    }
  }
  if (tool_faces_.groups[of_tool.group].children[of_tool.lane] == FeatureTree::kNone) return false;
  const Bounds tool_W = tool_faces_.bounds_W[of_tool.group][of_tool.lane];
  for (unsigned near = scene_->face_tree().groups()[0].bounds.overlapping(tool_W); near != 0;
       near &= near - 1)
    if (crosses(of_tool, {0, lowest_bit(near)})) return true;
  return false;
}

// Of two lanes that overlap. The tool's bounds are those of where the candidates were gathered, and hold what
// has moved since.
bool FeaturePairs::crosses(Lane of_tool, Lane of_scene) noexcept {
  const std::span<const FeatureTree::Group> scene = scene_->face_tree().groups();
  const std::uint32_t tool_child = tool_faces_.groups[of_tool.group].children[of_tool.lane],
                      scene_child = scene[of_scene.group].children[of_scene.lane];
  const bool tool_ends = (tool_child & FeatureTree::kFeature) != 0,
             scene_ends = (scene_child & FeatureTree::kFeature) != 0;
  if (tool_ends && scene_ends)
    return cross(tool_child ^ FeatureTree::kFeature, scene_child ^ FeatureTree::kFeature);
  const Bounds tool_W = tool_faces_.bounds_W[of_tool.group][of_tool.lane],
               scene_W = scene[of_scene.group].bounds[of_scene.lane];
  const bool splits_scene = tool_ends || (!scene_ends && scene_W.size() > tool_W.size());
  unsigned near = splits_scene ? scene[scene_child].bounds.overlapping(tool_W)
                               : pose(tool_faces_, tool_child).overlapping(scene_W);
  for (; near != 0; near &= near - 1) {
    const unsigned lane = lowest_bit(near);
    if (splits_scene ? crosses(of_tool, {scene_child, lane}) : crosses({tool_child, lane}, of_scene))
      return true;
  }
  return false;
}

// An edge of one of the faces through the other.
bool FeaturePairs::cross(std::uint32_t tool_face, std::uint32_t scene_face) const noexcept {
  const FeatureMesh::Face &of_tool = tool_->faces()[tool_face], &of_scene = scene_->faces()[scene_face];
  const auto scene = [&](unsigned i) -> const Vec3& { return scene_->vertices()[of_scene.corners[i % 3]]; };
  const std::array tool{in_world(of_tool.corners[0]), in_world(of_tool.corners[1]),
                        in_world(of_tool.corners[2])};
  const Vec3 nhat = R_WT_ * of_tool.nhat;
  for (unsigned e = 0; e < 3; ++e) {
    if (!tool_->edges()[of_tool.edges[e]].flat &&
        pierces(tool[e], tool[(e + 1) % 3], scene(0), scene(1), scene(2), of_scene.nhat))
      return true;
    if (!scene_->edges()[of_scene.edges[e]].flat &&
        pierces(scene(e), scene(e + 1), tool[0], tool[1], tool[2], nhat))
      return true;
  }
  return false;
}

std::size_t FeaturePairs::bytes() const {
  const auto of_posed = [](const Posed& tool) {
    return tool.groups.size() * (sizeof(std::uint32_t) + sizeof(Bounds4));
  };
  return tool_->bytes() + scene_->bytes() + of_posed(tool_vertices_) + of_posed(tool_edges_) +
         of_posed(tool_faces_) + 3 * kMostCandidates * sizeof(Candidate) + kMostPairs * sizeof(FeaturePair);
}

}  // namespace fulcrum
