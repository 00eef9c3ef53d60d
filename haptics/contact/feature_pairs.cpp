#include "haptics/contact/feature_pairs.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "haptics/math/rotation.h"

namespace fulcrum {
namespace {

constexpr double kLevel = 1e-9;    // m, what lies this far beyond a plane lies on it
constexpr double kGathered = 1.5;  // over the reach of a look: how far off the candidates are gathered
constexpr double kNoSlack = 1e-6;  // rad, of rounding
constexpr double kTurn = 0.02;     // rad, a tool that has turned farther has its candidates gathered anew
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

// Whether the place lies on the edge, or on its line where that goes on.
bool is_on(const FeatureMesh::Edge& edge, double part, double length) {
  const double before = -part * length, beyond = (part - 1) * length;
  return before <= ((edge.goes_on & 1u) != 0 ? FeaturePairs::kDeepest : 0) &&
         beyond <= ((edge.goes_on & 2u) != 0 ? FeaturePairs::kDeepest : 0);
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
      tool_vertices_(tool_->vertex_tree(), kMostTurn + kTurn),
      tool_edges_(tool_->edge_tree(), 2 * kMostTurn + kTurn),  // both edges of a pair may be off by it
      tool_faces_(tool_->face_tree(), kMostTurn + kTurn) {
  for (std::vector<Candidate>* candidates : {&vertex_faces_, &face_vertices_, &edge_edges_})
    candidates->reserve(kMostCandidates);
  pairs_.reserve(kMostPairs);
}

bool FeaturePairs::look(const Pose& X_WT, double reach) noexcept {
  odometer_ += way(X_WT_, X_WT);
  X_WT_ = X_WT;
  R_WT_ = X_WT.q.toRotationMatrix();
  reach_ = std::max(reach, kDeepest);
  complete_ = true;
  pairs_.clear();
  least_gap_ = std::numeric_limits<double>::infinity();
  // As long as what was gathered holds all that can have come within reach.
  const bool holds = gathered_reach_ >= reach_ + way(X_WT_gathered_, X_WT) &&
                     angle_between(X_WT_gathered_.q, X_WT.q) < kTurn;
  if (!holds) {
    gathered_reach_ = kGathered * reach_;
    X_WT_gathered_ = X_WT;
    gather();
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
    if (!complete_) gathered_reach_ = -1;
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
  if (candidates.size() == kMostCandidates)
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
      tool_vertices_, scene.face_tree(),
      [&](std::uint32_t v, const Vec3& axis_W, std::uint32_t g) {
        const FeatureMesh::Face& face = scene.faces()[g];
        const NormalCone& of_vertex = tool.vertex_normals()[v];
        if (!of_face(
                scene, face, true,
                [&](const NormalCone& cone) {
                  return of_vertex.opposes(axis_W, cone, tool_vertices_.slack);
                }))
          return;
        keep(vertex_faces_, v, g);
      });
  gather_kind(
      tool_faces_, scene.vertex_tree(),
      [&](std::uint32_t f, const Vec3&, std::uint32_t v) {
        const FeatureMesh::Face& face = tool.faces()[f];
        const NormalCone& of_vertex = scene.vertex_normals()[v];
        const Vec3 axis_T = R_WT_.transpose() * of_vertex.axis();
        if (!of_face(
                tool, face, false,
                [&](const NormalCone& cone) { return of_vertex.opposes(axis_T, cone, tool_faces_.slack); }))
          return;
        keep(face_vertices_, f, v);
      });
  gather_kind(tool_edges_, scene.edge_tree(),
              [&](std::uint32_t e, const Vec3&, std::uint32_t k) { keep(edge_edges_, e, k); });
}

FeaturePairs::Posed::Posed(const FeatureTree& of, double turn)
    : tree(&of),
      slack(Vec3::UnitX(), turn),
      gathering(of.nodes()),
      box_W(of.nodes()),
      axis_W(of.nodes()),
      feature_box_W(of.features()),
      feature_axis_W(of.features()) {}

void FeaturePairs::pose(Posed& tool, std::uint32_t node) noexcept {
  if (tool.gathering[node] == gathering_) return;
  tool.gathering[node] = gathering_;
  const Mat3 sizes = R_WT_.cwiseAbs();
  // A box along the axes of W that holds all that is nearer than gathered_reach_ to a box of the tool.
  const auto around = [&](const Box3& box_T) {
    const Vec3 centre = R_WT_ * box_T.center() + X_WT_.p;
    const Vec3 half = (sizes * box_T.sizes() / 2).array() + gathered_reach_;
    return Box3(centre - half, centre + half);
  };
  const FeatureTree::Node& of_tool = tool.tree->node(node);
  tool.box_W[node] = around(of_tool.box);
  tool.axis_W[node] = R_WT_ * of_tool.cone.axis();
  for (std::uint32_t i = 0; i < of_tool.count; ++i) {
    const TreeFeature& feature = tool.tree->of(of_tool)[i];
    tool.feature_box_W[of_tool.first + i] = around(feature.box);
    tool.feature_axis_W[of_tool.first + i] = R_WT_ * feature.cone.axis();
  }
}

template <class Take>
void FeaturePairs::gather_kind(Posed& tool, const FeatureTree& scene, const Take& take) noexcept {
  if (!tool.tree->empty() && !scene.empty()) descend(tool, scene, 0, 0, take);
}

template <class Take>
void FeaturePairs::descend(Posed& tool, const FeatureTree& scene, std::uint32_t tool_node,
                           std::uint32_t scene_node, const Take& take) noexcept {
  pose(tool, tool_node);
  const FeatureTree::Node &of_tool = tool.tree->node(tool_node), &of_scene = scene.node(scene_node);
  if (!tool.box_W[tool_node].intersects(of_scene.box)) return;
  if (!of_tool.cone.opposes(tool.axis_W[tool_node], of_scene.cone, tool.slack)) return;
  if (of_tool.count > 0 && of_scene.count > 0) {
    const std::span<const TreeFeature> of_leaf = tool.tree->of(of_tool);
    for (std::uint32_t i = 0; i < of_tool.count; ++i)
      for (const TreeFeature& feature : scene.of(of_scene))
        if (tool.feature_box_W[of_tool.first + i].intersects(feature.box) &&
            of_leaf[i].cone.opposes(tool.feature_axis_W[of_tool.first + i], feature.cone, tool.slack))
          take(of_leaf[i].which, tool.feature_axis_W[of_tool.first + i], feature.which);
    return;
  }
  const bool split_tool = of_scene.count > 0 || (of_tool.count == 0 && of_tool.radius > of_scene.radius);
  for (std::uint32_t child = 0; child < 2; ++child)
    if (split_tool)
      descend(tool, scene, of_tool.first + child, scene_node, take);
    else
      descend(tool, scene, tool_node, of_scene.first + child, take);
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

void FeaturePairs::vertex_on_face(Candidate& candidate) noexcept {
  const std::span<const Vec3> scene = scene_->vertices();
  const FeatureMesh::Face& face = scene_->faces()[candidate.scene];
  const Vec3 p = in_world(candidate.tool);
  const Vec3& corner = scene[face.corners[0]];
  const double height = face.nhat.dot(p - corner);
  candidate.due = odometer_ + std::abs(height);
  if (std::abs(height) > reach_) return;
  const TrianglePoint closest =
      closest_on_triangle(p, corner, scene[face.corners[1]], scene[face.corners[2]]);
  const double distance = std::sqrt(closest.squared);
  candidate.due = odometer_ + distance;
  if (distance > reach_) return;
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
  candidate.due = odometer_ + std::abs(height);
  if (std::abs(height) > reach_) return;
  const TrianglePoint closest = closest_on_triangle(p, corner, tool[face.corners[1]], tool[face.corners[2]]);
  const double distance = std::sqrt(closest.squared);
  candidate.due = odometer_ + distance;
  if (distance > reach_) return;
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
  candidate.due = odometer_ + std::abs(gap);
  if (std::abs(gap) > reach_) return;
  if (!on_side(of_scene.across, nhat, -1, kMostTurn) ||
      !on_side(of_tool.across, R_WT_.transpose() * nhat, 1, kMostTurn))
    return;
  if (gap >= -kDeepest) add(kEdgeEdge, candidate.tool, candidate.scene, p, nhat, gap);
}

bool FeaturePairs::crosses(std::size_t first_face, std::size_t count) const noexcept {
  const std::size_t end = std::min(first_face + count, faces());
  for (std::size_t f = first_face; f < end; ++f) {
    const FeatureMesh::Face& face = tool_->faces()[f];
    const std::array corners{in_world(face.corners[0]), in_world(face.corners[1]), in_world(face.corners[2])};
    Box3 box(corners[0], corners[0]);
    box.extend(corners[1]).extend(corners[2]);
    if (pierced(face, corners, box, 0)) return true;
  }
  return false;
}

bool FeaturePairs::pierced(const FeatureMesh::Face& face, const std::array<Vec3, 3>& corners, const Box3& box,
                           std::uint32_t scene_node) const noexcept {
  const FeatureTree& tree = scene_->face_tree();
  const FeatureTree::Node& node = tree.node(scene_node);
  if (!box.intersects(node.box)) return false;
  if (node.count == 0)
    return pierced(face, corners, box, node.first) || pierced(face, corners, box, node.first + 1);
  const Vec3 nhat = R_WT_ * face.nhat;
  for (const TreeFeature& feature : tree.of(node)) {
    if (!box.intersects(feature.box)) continue;
    const FeatureMesh::Face& of_scene = scene_->faces()[feature.which];
    const auto scene = [&](unsigned i) -> const Vec3& { return scene_->vertices()[of_scene.corners[i % 3]]; };
    for (unsigned e = 0; e < 3; ++e) {
      if (!tool_->edges()[face.edges[e]].flat &&
          pierces(corners[e], corners[(e + 1) % 3], scene(0), scene(1), scene(2), of_scene.nhat))
        return true;
      if (!scene_->edges()[of_scene.edges[e]].flat &&
          pierces(scene(e), scene(e + 1), corners[0], corners[1], corners[2], nhat))
        return true;
    }
  }
  return false;
}

std::size_t FeaturePairs::bytes() const {
  const auto of_posed = [](const Posed& tool) {
    return tool.box_W.size() * (sizeof(std::uint32_t) + sizeof(Box3) + sizeof(Vec3)) +
           tool.feature_box_W.size() * (sizeof(Box3) + sizeof(Vec3));
  };
  return tool_->bytes() + scene_->bytes() + of_posed(tool_vertices_) + of_posed(tool_edges_) +
         of_posed(tool_faces_) + 3 * kMostCandidates * sizeof(Candidate) + kMostPairs * sizeof(FeaturePair);
}

}  // namespace fulcrum
