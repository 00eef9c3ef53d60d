#pragma once
// Whether a tool's surface and a scene's go through each other: an edge of one through a face of the other.
// A tool that is wholly inside of the scene crosses nothing.

#include <cstdint>
#include <memory>
#include <vector>

#include "haptics/geometry/bounds.h"
#include "haptics/geometry/feature_mesh.h"
#include "haptics/math/pose.h"

namespace fulcrum {

class FeatureCrossings {
public:
  static constexpr unsigned kParts = 64;

  FeatureCrossings(std::shared_ptr<const FeatureMesh> tool_T, std::shared_ptr<const FeatureMesh> scene_W);

  // With the tool at X_WT: of all of the tool's faces, or of one of kParts parts of them alone.
  bool crosses(const Pose& X_WT) noexcept;
  bool crosses(const Pose& X_WT, unsigned part) noexcept;
  std::size_t bytes() const;

private:
  // One lane of a group of either tree.
  struct Lane {
    std::uint32_t group;
    unsigned lane;
  };
  void put(const Pose& X_WT) noexcept;
  bool crosses(unsigned part) noexcept;
  const Bounds4& pose(std::uint32_t group) noexcept;
  bool crosses(Lane of_tool, Lane of_scene) noexcept;
  bool cross(std::uint32_t tool_face, std::uint32_t scene_face) const noexcept;

  std::shared_ptr<const FeatureMesh> tool_, scene_;
  Pose X_WT_;
  Mat3 R_WT_ = Mat3::Identity();
  std::uint64_t looks_ = 0;  // how many there were
  // The tree of the tool's faces, its groups in W: those that looks have come to.
  std::vector<std::uint64_t> look_of_;  // (groups)
  std::vector<Bounds4> bounds_W_;       // (groups)
};

}  // namespace fulcrum
