#pragma once
// Pushed axes -> a handle that moves as fast as they are pushed, as seen from the camera: a cap or a stick
// has a middle and no way of its own to go.
//
//     v = c(push) v_full,    c(push) = push |push|
//
// so that half a push is a quarter of the speed, and the end of a push is fine. Speed follows by a
// first-order lag, so that a report which comes every few milliseconds is no step of the force.

#include "drivers/rate/pushed_axes.h"
#include "haptics/math/pose.h"

namespace fulcrum {

// What the trainee sees, and whether the tool may move.
struct SeenFrame {
  Quat q_WV = Quat::Identity();  // V: x right, y up, z toward the person
  double height = 0.2;           // m, of the picture at the tool's distance
  bool rests = false;            // a stop is a pause: the tool stays where it is
};

struct RateControlDesc {
  double heights_per_s = 0.5;  // of the picture's height, in a second of full push
  double full_turn = 1.6;      // rad/s
  double lag = 15e-3;          // s
};

class RateControl {
public:
  RateControl(const RateControlDesc& desc, const Pose& X_WH, double tick_s);

  // One tick.
  const Pose& advance(const PushedAxes& axes, const SeenFrame& seen) noexcept;
  const Pose& X_WH() const { return X_WH_; }

private:
  RateControlDesc desc_;
  double tick_s_, follow_;
  Pose X_WH_;
  Vec3 v_W_ = Vec3::Zero(), w_W_ = Vec3::Zero();  // (3) m/s; rad/s
};

}  // namespace fulcrum
