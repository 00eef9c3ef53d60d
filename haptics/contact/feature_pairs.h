#pragma once
// A tool's vertices, edges and faces against a scene's: which of them are near each other, how far apart, and
// along which normal; and whether the surfaces cross. Measured on the triangles, in double precision.

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "haptics/geometry/feature_mesh.h"
#include "haptics/geometry/point_triangle.h"
#include "haptics/math/pose.h"

namespace fulcrum {

// A place where the two surfaces are nearest to each other, locally, or would be if the tool turned by
// kMostTurn: all that is around either feature lies on its own side of the plane across nhat, but for that
// angle. Edges that are parallel, and edges that do not bend outwards, are in no pair of edges: their ends
// and the faces beside them are. Where the surface goes on beyond a face's or an edge's end as a wall does
// beyond a room's corner, the pair does, too, for kDeepest.
struct FeaturePair {
  std::uint64_t key = 0;       // the same two features have the same from look to look
  Vec3 p_W = Vec3::Zero();     // (3) m, on the tool
  Vec3 nhat_W = Vec3::Zero();  // (3) unit, from the scene to the tool
  double gap = 0;              // m, along nhat; below 0 the surfaces have passed each other there

  // A name of 32 bits, which two pairs may share: then one of them has the other's guess.
  std::uint32_t number() const { return static_cast<std::uint32_t>(key ^ key >> 29); }
};

class FeaturePairs {
public:
  static constexpr std::size_t kMostCandidates = 1u << 16;  // of each kind
  static constexpr std::size_t kMostPairs = 1u << 14;
  static constexpr double kMostTurn = 0.03;  // rad, a longer turn may meet what is no pair
  static constexpr double kDeepest = 50e-6;  // m, what has passed farther is no pair

  FeaturePairs(std::shared_ptr<const FeatureMesh> tool_T, std::shared_ptr<const FeatureMesh> scene_W);

  // The pairs nearer than `reach` m, and those that have passed each other, with the tool at X_WT. False:
  // there were more than fit, or more candidates of a kind than `most`; then pairs() has not all of them, or
  // none.
  bool look(const Pose& X_WT, double reach, std::size_t most = kMostCandidates) noexcept;
  std::span<const FeaturePair> pairs() const { return pairs_; }
  double least_gap() const { return least_gap_; }  // m, of the pairs; infinite: there are none
  bool none_near() const;

  // Whether, at the last look's pose, an edge of one goes through a face of the other: any, or of a part of
  // the tool's faces alone. A tool that is wholly inside of the scene crosses nothing.
  static constexpr unsigned kParts = 64;
  bool crosses() noexcept;
  bool crosses(unsigned part) noexcept;
  std::size_t bytes() const;

private:
  // Two features that may be nearest to each other at poses near the one where they were gathered.
  struct Candidate {
    std::uint32_t tool, scene;
    double due;  // m, on the odometer: until then the two cannot have come together
  };
  // m, on the odometer: what is that far apart now is not measured anew before it comes into a look's reach,
  // nor, once it has passed, before it is no deeper than kDeepest.
  double due(double gap) const noexcept;
  bool is_far(double gap) const noexcept;  // at this look
  // m: no point of the tool moves farther on a straight way from one pose to the other.
  double way(const Pose& from, const Pose& to) const noexcept;
  void gather() noexcept;
  // A tree of the tool's, and its groups in W: those that the last gathering has visited.
  struct Posed {
    explicit Posed(const FeatureTree& tree);
    std::span<const FeatureTree::Group> groups;
    NormalCone slack;                      // its angle: how far normals of a candidate may be from opposite
    std::vector<std::uint32_t> gathering;  // (groups) in which gathering_ a group's bounds were made
    std::vector<Bounds4> bounds_W;         // (groups)
  };
  const Bounds4& pose(Posed& tool, std::uint32_t group) noexcept;
  // One lane of a group of either tree.
  struct Lane {
    std::uint32_t group;
    unsigned lane;
  };
  template <class Take>
  void descend(Posed& tool, const FeatureTree& scene, Lane of_tool, Lane of_scene, const Take& take) noexcept;
  template <class Take>
  void gather_kind(Posed& tool, const FeatureTree& scene, double slack, const Take& take) noexcept;
  void keep(std::vector<Candidate>& candidates, std::uint32_t tool, std::uint32_t scene) noexcept;
  void vertex_on_face(Candidate& candidate) noexcept;
  void face_on_vertex(Candidate& candidate) noexcept;
  void edge_on_edge(Candidate& candidate) noexcept;
  bool could_oppose(const FeatureMesh::Edge& of_tool, const FeatureMesh::Edge& of_scene) const noexcept;
  bool crosses(Lane of_tool, Lane of_scene) noexcept;
  bool cross(std::uint32_t tool_face, std::uint32_t scene_face) const noexcept;
  Vec3 in_world(std::uint32_t tool_vertex) const { return R_WT_ * tool_->vertices()[tool_vertex] + X_WT_.p; }
  void add(std::uint64_t kind, std::uint32_t tool, std::uint32_t scene, const Vec3& p_W, const Vec3& nhat_W,
           double gap) noexcept;

  std::shared_ptr<const FeatureMesh> tool_, scene_;
  Pose X_WT_;
  Mat3 R_WT_ = Mat3::Identity();
  double reach_ = 0;       // m, of the look
  std::size_t most_ = 0;   // candidates, likewise
  double odometer_ = 0;    // m, no point of the tool has come farther from look to look
  bool gathered_ = false;  // the candidates are all that there are
  Pose X_WT_gathered_;     // where they were gathered, with
  Mat3 R_WT_gathered_ = Mat3::Identity();
  double gathered_reach_ = 0;    // m
  std::uint32_t gathering_ = 0;  // how many there were
  Posed tool_vertices_, tool_edges_, tool_faces_;
  std::vector<Candidate> vertex_faces_, face_vertices_, edge_edges_;  // the tool's feature first
  std::vector<FeaturePair> pairs_;
  double least_gap_ = 0;
  bool complete_ = true;
};

}  // namespace fulcrum
