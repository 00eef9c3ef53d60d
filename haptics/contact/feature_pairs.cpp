#include "haptics/contact/feature_pairs.h"

#include <algorithm>
#include <cmath>

#include "haptics/math/rotation.h"

namespace fulcrum {
namespace {

constexpr double kLevel = 1e-9;  // m, what lies this far beyond a plane lies on it
enum Kind : std::uint64_t { kVertexFace, kVertexEdge, kVertexVertex, kFaceVertex, kEdgeVertex, kEdgeEdge };

struct ClosestOfEdges {
  double s = 0, t = 0;  // 0 to 1 along either
  bool inside = false;  // of both
};

ClosestOfEdges closest_of_edges(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1) {
  const Vec3 u = a1 - a0, v = b1 - b0, w = a0 - b0;
  const double a = u.dot(u), b = u.dot(v), c = v.dot(v), d = u.dot(w), e = v.dot(w);
  const double determinant = a * c - b * b;
  if (!(determinant > 1e-12 * a * c)) return {};  // parallel: their ends tell
  ClosestOfEdges closest{(b * e - c * d) / determinant, (a * e - b * d) / determinant, false};
  closest.inside = closest.s >= 0 && closest.s <= 1 && closest.t >= 0 && closest.t <= 1;
  return closest;
}

// Whether the segment goes through the triangle.
bool pierces(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& nhat) {
  const double from = nhat.dot(p - a), to = nhat.dot(q - a);
  if (!(from * to < 0)) return false;
  const Vec3 x = p + (q - p) * (from / (from - to));
  return nhat.dot((b - a).cross(x - a)) > 0 && nhat.dot((c - b).cross(x - b)) > 0 &&
         nhat.dot((a - c).cross(x - c)) > 0;
}

}  // namespace

FeaturePairs::FeaturePairs(std::shared_ptr<const FeatureMesh> tool_T,
                           std::shared_ptr<const FeatureMesh> scene_W)
    : tool_(std::move(tool_T)),
      scene_(std::move(scene_W)),
      p_W_(tool_->vertices().size()),
      nhat_W_(tool_->faces().size()) {
  face_pairs_.reserve(kMostFacePairs);
  pairs_.reserve(kMostPairs);
}

bool FeaturePairs::look(const Pose& X_WT, double reach) noexcept {
  odometer_ += way(X_WT_, X_WT);
  X_WT_ = X_WT;
  R_WT_ = X_WT.q.toRotationMatrix();
  reach_ = reach;
  crosses_ = false;
  complete_ = true;
  pairs_.clear();
  for (std::size_t i = 0; i < p_W_.size(); ++i) p_W_[i] = R_WT_ * tool_->vertices()[i] + X_WT.p;
  for (std::size_t i = 0; i < nhat_W_.size(); ++i) nhat_W_[i] = R_WT_ * tool_->faces()[i].nhat;
  // As long as what was gathered holds all that can have come within reach.
  if (!(gathered_reach_ >= reach + way(X_WT_gathered_, X_WT))) {
    gathered_reach_ = 2 * reach;
    X_WT_gathered_ = X_WT;
    if (!gather(gathered_reach_)) {
      complete_ = false;
      gathered_reach_ = -1;
    }
  }
  const double due = odometer_ + reach_;
  for (FacePair& faces : face_pairs_)
    if (!(faces.due > due)) measure(faces);
  return complete_;
}

double FeaturePairs::way(const Pose& from, const Pose& to) const noexcept {
  return (to.p - from.p).norm() + angle_between(to.q, from.q) * tool_->radius() + kLevel;
}

bool FeaturePairs::gather(double reach) noexcept {
  face_pairs_.clear();
  descend(0, 0, reach);
  return complete_;
}

void FeaturePairs::descend(std::uint32_t tool_node, std::uint32_t scene_node, double reach) noexcept {
  const FeatureMesh::Node& tool = tool_->nodes()[tool_node];
  const FeatureMesh::Node& scene = scene_->nodes()[scene_node];
  const double far = tool.radius + reach;
  if (scene.box.squaredExteriorDistance(Vec3(R_WT_ * tool.centre + X_WT_.p)) > far * far) return;
  if (tool.count > 0 && scene.count > 0) {
    compare_leaves(tool, scene, reach);
    return;
  }
  const bool of_tool = scene.count > 0 || (tool.count == 0 && tool.radius > scene.radius);
  for (std::uint32_t child = 0; child < 2; ++child)
    if (of_tool)
      descend(tool.first + child, scene_node, reach);
    else
      descend(tool_node, scene.first + child, reach);
}

void FeaturePairs::compare_leaves(const FeatureMesh::Node& tool, const FeatureMesh::Node& scene,
                                  double reach) noexcept {
  for (std::uint32_t i = tool.first; i < tool.first + tool.count; ++i) {
    const std::uint32_t f = tool_->order()[i];
    Box3 box;
    for (const std::uint32_t v : tool_->faces()[f].corners) box.extend(p_W_[v]);
    for (std::uint32_t j = scene.first; j < scene.first + scene.count; ++j) {
      const std::uint32_t g = scene_->order()[j];
      if (box.squaredExteriorDistance(scene_->faces()[g].box) > reach * reach) continue;
      if (face_pairs_.size() == kMostFacePairs) {
        complete_ = false;
        return;
      }
      face_pairs_.push_back({f, g, 0});
    }
  }
}

void FeaturePairs::measure(FacePair& faces) noexcept {
  const FeatureMesh::Face& f = tool_->faces()[faces.tool];
  const FeatureMesh::Face& g = scene_->faces()[faces.scene];
  // Which side of the other's plane either lies on, and how far at least.
  const Vec3& a = p_W_[f.corners[0]];
  const Vec3& b = scene_->vertices()[g.corners[0]];
  double tool_low = 1e9, tool_high = -1e9, scene_low = 1e9, scene_high = -1e9;
  for (unsigned i = 0; i < 3; ++i) {
    const double h = g.nhat.dot(p_W_[f.corners[i]] - b);
    const double k = nhat_W_[faces.tool].dot(scene_->vertices()[g.corners[i]] - a);
    tool_low = std::min(tool_low, h);
    tool_high = std::max(tool_high, h);
    scene_low = std::min(scene_low, k);
    scene_high = std::max(scene_high, k);
  }
  faces.due = odometer_ + std::max(std::max(tool_low, -tool_high), std::max(scene_low, -scene_high));
  if (tool_low > reach_ || tool_high < -reach_ || scene_low > reach_ || scene_high < -reach_) return;
  if (!crosses_ && tool_low < 0 && tool_high > 0 && scene_low < 0 && scene_high > 0)
    crosses_ = pierced(faces);
  vertex_on_face(faces);
  face_on_vertex(faces);
  edge_on_edge(faces);
}

bool FeaturePairs::pierced(const FacePair& faces) const noexcept {
  const FeatureMesh::Face& f = tool_->faces()[faces.tool];
  const FeatureMesh::Face& g = scene_->faces()[faces.scene];
  const auto tool = [&](unsigned i) -> const Vec3& { return p_W_[f.corners[i % 3]]; };
  const auto scene = [&](unsigned i) -> const Vec3& { return scene_->vertices()[g.corners[i % 3]]; };
  for (unsigned e = 0; e < 3; ++e) {
    if (!tool_->edges()[f.edges[e]].flat &&
        pierces(tool(e), tool(e + 1), scene(0), scene(1), scene(2), g.nhat))
      return true;
    if (!scene_->edges()[g.edges[e]].flat &&
        pierces(scene(e), scene(e + 1), tool(0), tool(1), tool(2), nhat_W_[faces.tool]))
      return true;
  }
  return false;
}

void FeaturePairs::add(std::uint64_t kind, std::uint32_t tool, std::uint32_t scene, const Vec3& p_W,
                       const Vec3& nhat_W, double gap) noexcept {
  if (pairs_.size() == kMostPairs) {
    complete_ = false;
    return;
  }
  pairs_.push_back({kind << 60 | std::uint64_t{tool} << 30 | scene, p_W, nhat_W, gap});
}

namespace {

// Whether all that is around lies on one side of the plane through p: above it (sign 1), or below (-1).
bool on_side(std::span<const Vec3> vertices, std::span<const std::uint32_t> around, const Vec3& p,
             const Vec3& nhat, double sign) {
  return std::all_of(
      around.begin(), around.end(),
      [&](std::uint32_t v) { return sign * nhat.dot(vertices[v] - p) >= -kLevel; });
}

}  // namespace

void FeaturePairs::vertex_on_face(const FacePair& faces) noexcept {
  const FeatureMesh::Face& f = tool_->faces()[faces.tool];
  const FeatureMesh::Face& g = scene_->faces()[faces.scene];
  const std::span<const Vec3> tool = p_W_, scene = scene_->vertices();
  for (unsigned i = 0; i < 3; ++i) {
    if ((f.own_corners >> i & 1u) == 0) continue;
    const std::uint32_t vertex = f.corners[i];
    const Vec3& p = p_W_[vertex];
    const double height = g.nhat.dot(p - scene[g.corners[0]]);
    if (!(height > 0) || height > reach_) continue;
    const TrianglePoint closest =
        closest_on_triangle(p, scene[g.corners[0]], scene[g.corners[1]], scene[g.corners[2]]);
    if (!(closest.squared <= reach_ * reach_)) continue;
    const double gap = std::sqrt(closest.squared);
    const Vec3 nhat = closest.feature == TriangleFeature::face || !(gap > kLevel)
                          ? g.nhat
                          : Vec3((p - closest.point) / gap);
    if (!on_side(tool, tool_->around(vertex), p, nhat, 1)) continue;
    const auto which = static_cast<unsigned>(closest.feature);
    if (closest.feature == TriangleFeature::face) {
      add(kVertexFace, vertex, faces.scene, p, nhat, gap);
    } else if (which < 3) {
      const FeatureMesh::Edge& edge = scene_->edges()[g.edges[which]];
      if ((edge.convex || edge.flat) && on_side(scene, edge.opposite, closest.point, nhat, -1))
        add(kVertexEdge, vertex, g.edges[which], p, nhat, gap);
    } else {
      const std::uint32_t corner = g.corners[which - 3];
      if (on_side(scene, scene_->around(corner), closest.point, nhat, -1))
        add(kVertexVertex, vertex, corner, p, nhat, gap);
    }
  }
}

void FeaturePairs::face_on_vertex(const FacePair& faces) noexcept {
  const FeatureMesh::Face& f = tool_->faces()[faces.tool];
  const FeatureMesh::Face& g = scene_->faces()[faces.scene];
  const std::span<const Vec3> tool = p_W_, scene = scene_->vertices();
  for (unsigned i = 0; i < 3; ++i) {
    if ((g.own_corners >> i & 1u) == 0) continue;
    const std::uint32_t vertex = g.corners[i];
    const Vec3& p = scene[vertex];
    const double height = nhat_W_[faces.tool].dot(p - p_W_[f.corners[0]]);
    if (!(height > 0) || height > reach_) continue;
    const TrianglePoint closest =
        closest_on_triangle(p, p_W_[f.corners[0]], p_W_[f.corners[1]], p_W_[f.corners[2]]);
    if (!(closest.squared <= reach_ * reach_)) continue;
    const auto which = static_cast<unsigned>(closest.feature);
    if (which >= 3 && closest.feature != TriangleFeature::face)
      continue;  // vertex on vertex: found from there
    const double gap = std::sqrt(closest.squared);
    const Vec3 nhat = closest.feature == TriangleFeature::face || !(gap > kLevel)
                          ? Vec3(-nhat_W_[faces.tool])
                          : Vec3((closest.point - p) / gap);
    if (!on_side(scene, scene_->around(vertex), p, nhat, -1)) continue;
    if (closest.feature == TriangleFeature::face) {
      add(kFaceVertex, faces.tool, vertex, closest.point, nhat, gap);
    } else {
      const FeatureMesh::Edge& edge = tool_->edges()[f.edges[which]];
      if ((edge.convex || edge.flat) && on_side(tool, edge.opposite, closest.point, nhat, 1))
        add(kEdgeVertex, f.edges[which], vertex, closest.point, nhat, gap);
    }
  }
}

void FeaturePairs::edge_on_edge(const FacePair& faces) noexcept {
  const FeatureMesh::Face& f = tool_->faces()[faces.tool];
  const FeatureMesh::Face& g = scene_->faces()[faces.scene];
  const std::span<const Vec3> tool = p_W_, scene = scene_->vertices();
  for (unsigned i = 0; i < 3; ++i) {
    if ((f.own_edges >> i & 1u) == 0) continue;
    const FeatureMesh::Edge& of_tool = tool_->edges()[f.edges[i]];
    if (!of_tool.convex) continue;
    for (unsigned j = 0; j < 3; ++j) {
      if ((g.own_edges >> j & 1u) == 0) continue;
      const FeatureMesh::Edge& of_scene = scene_->edges()[g.edges[j]];
      if (!of_scene.convex) continue;
      const Vec3 &a0 = p_W_[of_tool.from], &a1 = p_W_[of_tool.to];
      const Vec3 &b0 = scene[of_scene.from], &b1 = scene[of_scene.to];
      const ClosestOfEdges closest = closest_of_edges(a0, a1, b0, b1);
      if (!closest.inside) continue;
      const Vec3 p = a0 + closest.s * (a1 - a0), q = b0 + closest.t * (b1 - b0);
      const double gap = (p - q).norm();
      if (gap > reach_ || !(gap > kLevel)) continue;
      const Vec3 nhat = (p - q) / gap;
      if (on_side(scene, of_scene.opposite, q, nhat, -1) && on_side(tool, of_tool.opposite, p, nhat, 1))
        add(kEdgeEdge, f.edges[i], g.edges[j], p, nhat, gap);
    }
  }
}

std::size_t FeaturePairs::bytes() const {
  return tool_->bytes() + scene_->bytes() + kMostFacePairs * sizeof(FacePair) +
         kMostPairs * sizeof(FeaturePair) + (p_W_.size() + nhat_W_.size()) * sizeof(Vec3);
}

}  // namespace fulcrum
