#pragma once
// How much room there is in and before the canal, looked up instead of computed.

#include <vector>

#include "tools/content/ear/flesh.h"
#include "tools/content/ear/needle.h"

namespace fulcrum::content {

class Room {
public:
  explicit Room(const Flesh& flesh);

  // About the distance (mm) to flesh or drum, negative in them; what lies beyond the grid is free.
  double at(const Eigen::Vector3d& p_W) const;

  // The least room about the balls of a needle; it stops looking below `least_wanted`.
  double clearance(const std::vector<Ball>& needle, const Eigen::Isometry3d& X_WT, double least_wanted) const;

private:
  std::vector<float> values_;
};

}  // namespace fulcrum::content
