#pragma once
// Continuous collision detection between a tool's features and a scene's: how far along a straight step
// vertices go through faces, and edges through edges. Between two places that are both free, what is sharp or
// thin may have gone through the other all the way.
// X. Provot, "Collision and self-collision handling in cloth model dedicated to design garments", Graphics
// Interface 1997.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "haptics/contact/feature_gathering.h"
#include "haptics/geometry/feature_mesh.h"
#include "haptics/math/pose.h"

namespace fulcrum {

class FeaturePassing {
public:
  // slack rad: by how much the faces beside two edges that meet may be off their own sides.
  FeaturePassing(std::shared_ptr<const FeatureMesh> tool_T, std::shared_ptr<const FeatureMesh> scene_W,
                 double slack);

  // 0 to 1: the part of the step from X_from to X_to that the tool may go until one of the candidates, which
  // were in by no more than `in` m, has gone in by `depth` m. Points go along straight lines, which are off
  // their arcs by radius x turn^2 / 8; the step has to be on the gathering's way.
  double free_part(const FeatureGathering& gathering, const Pose& X_from, const Pose& X_to, double in,
                   double depth) noexcept;
  std::size_t bytes() const;

private:
  // Of a vertex of the tool's, on this step.
  struct Ends {
    Vec3 from_W = Vec3::Zero(), to_W = Vec3::Zero();  // (3) m
    std::uint64_t step = 0;
  };
  const Ends& ends(std::uint32_t tool_vertex) noexcept;
  bool is_apart(const FeatureCandidate& candidate, std::span<const std::uint32_t> tool) noexcept;
  void vertex_through_face(const FeatureCandidate& candidate) noexcept;
  void face_over_vertex(const FeatureCandidate& candidate) noexcept;
  void edge_through_edge(const FeatureCandidate& candidate) noexcept;
  void stop(double at, double gap_after) noexcept;

  std::shared_ptr<const FeatureMesh> tool_, scene_;
  double slack_;  // rad
  Pose X_from_, X_to_;
  Mat3 R_from_ = Mat3::Identity(), R_to_ = Mat3::Identity();
  double in_ = 0, depth_ = 0;  // m
  double part_ = 1;
  std::uint64_t steps_ = 0;  // how many there were
  std::vector<Ends> ends_;   // (tool's vertices)
};

}  // namespace fulcrum
