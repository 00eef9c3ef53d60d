#pragma once
// A handle that follows a wanted pose smoothly: what wants it speaks only now and then, a tick comes each
// millisecond.

#include "haptics/math/pose.h"

namespace fulcrum {

class PoseFollower {
public:
  // lag: s, time constant of each of two first-order lags in a row: no step in speed.
  PoseFollower(const Pose& X_DH, double lag, double tick_s);

  // One tick towards it: where the handle is then.
  const Pose& follow(const Pose& wanted_X_DH) noexcept;

private:
  double part_;  // of the way to go that each lag goes in a tick
  Pose halfway_, X_DH_;
};

}  // namespace fulcrum
