#pragma once
// A passivity observer on the closed-loop port, at the device: the energy that the hand has put into the
// loop,
//     E_k = sum_j F_(j-1) . (x_j - x_(j-1)),   exact under a hold
// (B. Hannaford, J.-H. Ryu, "Time-domain passivity control of haptic interfaces", IEEE Trans. Robotics and
// Automation 18(1), 2002). Encoders count in steps, and what the handle does within a step cannot be seen:
// the port is the least that E can have been (counted_work.h), so that it reads no better than the loop is.
// By how much less it reads grows with the hand's way; passivity_controller.h takes that back from the hand's
// motion.
//
// Force and torque are those on the handle, the way is the handle's: all in D, in the device's own N, m and
// J.
//
// The port is opened when the force has ramped in, with what the virtual springs, the tool's motion and its
// weight can give back by then, and closed while the force is stopped or ramps: a gain that changes makes or
// eats energy by design. The weight is a store that the hand fills and empties: it is booked against the
// height of the tool.
//
// A device that senses an axis and does not push on it is no passive port by itself: what the hand winds up
// there comes back by another axis. That axis is booked at the port too, so that the port tells whether the
// loop makes energy. The same energy is also counted separately (`unrendered`): what the hand put in on an
// axis where the device cannot push back. No force is held there: the virtual spring is wound with the
// counts, from F_(k-1) to F_k, and nothing of it is unknown.

#include <algorithm>

#include "haptics/math/pose.h"
#include "haptics/math/wrench.h"
#include "haptics/safety/counted_work.h"
#include "haptics/safety/passivity_controller.h"

namespace fulcrum {

inline constexpr double kPortBound = -1e-4;  // J: below it the loop may have made energy

class PassivityObserver {
public:
  // step (6): of one count of the device in each axis of D, m and rad.
  PassivityObserver(const Vec6& step, bool renders_force, bool renders_torque);

  struct Port {
    Wrench F_H_D;        // on the handle about H, from now on; what an axis would render if it could
    double weight = 0;   // J, potential energy of the tool now, at the device
    double springs = 0;  // J, energy in the coupling and in the tool's motion now, at the device
    bool open = false;   // the force is there in full
  };
  // d_D (6): what was counted of the handle since the last call, m and rad.
  void update(const Vec6& d_D, const Port& port) noexcept;

  double port() const { return least_; }  // J, put in by the hand, at least
  // J, above 0: what the loop has made, and what it would have made once the springs have given back all they
  // hold; what has happened since the last count aside. 0 while the port is closed.
  PassivityController::Deficit deficit() const {
    if (!open_) return {};
    const double made = std::max(0.0, springs_ - before_ - stores_ - work_.likely());
    return {made, std::max(0.0, springs_ - before_ - stores_ - work_.least_counted()) - made};
  }
  double unrendered() const { return unrendered_; }  // J, of port() on axes that are not rendered

private:
  Vec6 rendered_;  // 1 for an axis that is pushed on, else 0
  CountedWork work_;
  bool open_ = false;
  Vec6 last_F_ = Vec6::Zero();
  double last_weight_ = 0, springs_ = 0;
  double before_ = 0;  // J, of port() when the port was opened last
  double stores_ = 0;  // J, since then: by weight and by axes that are not rendered
  double least_ = 0, unrendered_ = 0;
};

}  // namespace fulcrum
