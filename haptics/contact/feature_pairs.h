#pragma once
// A tool's vertices, edges and faces against a scene's: which of them are near each other, how far apart, and
// along which normal; and whether the surfaces cross. Measured on the triangles, in double precision.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "haptics/geometry/feature_mesh.h"
#include "haptics/geometry/point_triangle.h"
#include "haptics/math/pose.h"

namespace fulcrum {

// A place where the two surfaces are nearest to each other, locally: all that is around either feature lies
// on its own side of the plane across nhat. Edges that are parallel, and edges that do not bend outwards, are
// in no pair of edges: their ends and the faces beside them are.
struct FeaturePair {
  std::uint64_t key = 0;       // the same two features have the same from look to look
  Vec3 p_W = Vec3::Zero();     // (3) m, on the tool
  Vec3 nhat_W = Vec3::Zero();  // (3) unit, from the scene to the tool
  double gap = 0;              // m

  // A name of 32 bits, which two pairs may share: then one of them has the other's guess.
  std::uint32_t number() const { return static_cast<std::uint32_t>(key ^ key >> 29); }
};

class FeaturePairs {
public:
  static constexpr std::size_t kMostFacePairs = 1u << 16;
  static constexpr std::size_t kMostPairs = 1u << 14;

  FeaturePairs(std::shared_ptr<const FeatureMesh> tool_T, std::shared_ptr<const FeatureMesh> scene_W);

  // The pairs nearer than `reach` m with the tool at X_WT. False: there were more than fit.
  bool look(const Pose& X_WT, double reach) noexcept;
  std::span<const FeaturePair> pairs() const { return pairs_; }
  bool none_near() const { return face_pairs_.empty() && complete_; }
  // At the last look() an edge of one went through a face of the other. A tool that is wholly inside of the
  // scene crosses nothing.
  bool crosses() const { return crosses_; }
  std::size_t bytes() const;

private:
  struct FacePair {
    std::uint32_t tool, scene;
    double due;  // m, on the odometer: until then the two cannot have come together
  };
  // m: no point of the tool moves farther on a straight way from one pose to the other.
  double way(const Pose& from, const Pose& to) const noexcept;
  bool gather(double reach) noexcept;
  void descend(std::uint32_t tool_node, std::uint32_t scene_node, double reach) noexcept;
  void compare_leaves(const FeatureMesh::Node& tool, const FeatureMesh::Node& scene, double reach) noexcept;
  void measure(FacePair& faces) noexcept;
  void vertex_on_face(const FacePair& faces) noexcept;
  void face_on_vertex(const FacePair& faces) noexcept;
  void edge_on_edge(const FacePair& faces) noexcept;
  bool pierced(const FacePair& faces) const noexcept;
  void add(std::uint64_t kind, std::uint32_t tool, std::uint32_t scene, const Vec3& p_W, const Vec3& nhat_W,
           double gap) noexcept;

  std::shared_ptr<const FeatureMesh> tool_, scene_;
  Pose X_WT_;
  Mat3 R_WT_ = Mat3::Identity();
  double reach_ = 0;            // m, of the look
  double odometer_ = 0;         // m, no point of the tool has come farther from look to look
  Pose X_WT_gathered_;          // where face_pairs_ were gathered, with
  double gathered_reach_ = -1;  // m
  std::vector<FacePair> face_pairs_;
  std::vector<Vec3> p_W_;     // (tool's vertices x 3) m
  std::vector<Vec3> nhat_W_;  // (tool's faces x 3) unit
  std::vector<FeaturePair> pairs_;
  bool crosses_ = false, complete_ = true;
};

}  // namespace fulcrum
