#pragma once
// A passivity observer on the closed-loop port: the energy that the hand has put into the loop,
//     E_k = sum_j F_(j-1) . (x_j - x_(j-1)),   exact under a hold
// (B. Hannaford, J.-H. Ryu, "Time-domain passivity control of haptic interfaces", IEEE Trans. Robotics and
// Automation 18(1), 2002). Of a count of an encoder, d, the handle went only a part s under the force that
// was held in that tick, and the rest in the ticks around it, under that force and the next alike:
//     E_k = E_(k-1) + F_(k-1) . d + 1/2 (F_k - F_(k-1)) . (d - s)
// (estimate/counted_motion.h), which is the same from two counts a tick on. What lies within a count cannot
// be seen: each reversal can hide k step / 2 times the way of a tick, at most k step^2 / 2.
//
// The port is opened when the force has ramped in, with what the virtual springs, the tool's motion and its
// weight can give back by then, and closed while the force is stopped or ramps: a gain that changes makes or
// eats energy by design. The weight is a store that the hand fills and empties: it is booked against the
// height of the tool.
//
// A device that senses an axis and does not push on it is no passive port by itself: what the hand winds up
// there comes back by another axis. That axis is booked at the port too, so that the port tells whether the
// loop makes energy, and on an account of its own, which tells what it brought in for nothing. No force is
// held there: the handle jumps and the virtual spring is wound with it, from F_(k-1) to F_k (s = 0).
//
// Everything is counted in the scene and shown as the device sees it: force_scale / position_scale times.

#include <algorithm>

#include "haptics/estimate/counted_motion.h"
#include "haptics/math/pose.h"
#include "haptics/math/wrench.h"

namespace fulcrum {

inline constexpr double kPortBound = -1e-4;  // J: below it the loop has made energy

class EnergyLedger {
public:
  // to_device: force_scale / position_scale.
  EnergyLedger(double to_device, bool renders_force, bool renders_torque)
      : to_device_(to_device), renders_force_(renders_force), renders_torque_(renders_torque) {}

  struct Port {
    Wrench F_H_W;       // on the handle about H, from now on, in the scene's scale; what an axis would render
                        // if it could
    double weight = 0;  // J, potential energy of the tool now
    double springs = 0;  // J, energy in the coupling and in the tool's motion now
    bool open = false;   // the force is there in full
  };
  // d (6): what the handle did since the last call, m and rad in W; within_tick (6): the part of it that was
  // under the last call's wrench alone.
  void book(const Vec6& d, const Vec6& within_tick, const Port& port) noexcept;

  double port() const { return to_device_ * port_; }  // J, put in by the hand
  // J, above 0: what the loop has made, and what it would have made once the springs have given back all they
  // hold. 0 while the port is closed.
  double deficit() const { return open_ ? to_device_ * std::max(0.0, springs_ - port_) : 0.0; }
  double unrendered() const { return to_device_ * unrendered_; }  // J, of that on axes that are not rendered

private:
  double to_device_;
  bool renders_force_, renders_torque_;
  bool open_ = false;
  Vec6 last_F_ = Vec6::Zero();
  double last_weight_ = 0, springs_ = 0;
  double port_ = 0, unrendered_ = 0;
};

}  // namespace fulcrum
