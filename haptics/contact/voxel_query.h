#pragma once
// The classic voxel method, to compare with: the scene as occupied voxels, and where a point of the tool lies
// in one, its depth below the plane through the voxel's centre that its own normal gives. W. A. McNeely, K.
// D. Puterbaugh, J. J. Troy, "Six degree-of-freedom haptic rendering using voxel sampling", SIGGRAPH 1999.
// Depth is wrong by up to sqrt(3) / 2 of a voxel, and jumps by as much.

#include <cstdint>
#include <memory>
#include <vector>

#include "haptics/contact/query.h"

namespace fulcrum {

class VoxelQuery {
public:
  // Voxels are the field's cells.
  VoxelQuery(std::shared_ptr<const Pointshell> shell_T, std::shared_ptr<const DistanceField> field_W);

  // As ContactQuery::run(); every point is looked up.
  ContactQuery::Outcome run(const Pose& X_WT, ContactSet& set) const noexcept;

  std::size_t bytes() const { return state_.capacity(); }

private:
  enum class State : std::uint8_t { free, surface, inside };
  State at(const Vec3& p_W, Vec3& centre_W) const noexcept;

  std::shared_ptr<const Pointshell> shell_;
  std::shared_ptr<const DistanceField> field_;
  Vec3 origin_W_;
  double voxel_;              // m
  std::vector<State> state_;  // (slots x 8^3) of the bricks that the surface comes near
};

}  // namespace fulcrum
