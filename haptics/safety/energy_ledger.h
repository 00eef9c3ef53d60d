#pragma once
// A passivity observer on the closed-loop port: the energy that the hand has put into the loop,
//     E_k = sum_j F_(j-1) . (x_j - x_(j-1)),   exact under a hold
// (B. Hannaford, J.-H. Ryu, "Time-domain passivity control of haptic interfaces", IEEE Trans. Robotics and
// Automation 18(1), 2002). It is opened when the force has ramped in, with what the virtual springs, the
// tool's motion and its weight can give back by then, and closed while the force is stopped or ramps: a gain
// that changes makes or eats energy by design. The weight is a store that the hand fills and empties: it is
// booked against the height of the tool.
//
// A device that senses rotation and pushes back in translation alone is no passive port by itself: what the
// hand winds up by turning comes back as force. That torque is booked at the port as if it were rendered, so
// that the port tells whether the loop makes energy, and on an account of its own, which tells what turning
// brought in for nothing.
//
// Everything is counted in the scene and shown as the device sees it: force_scale / position_scale times.

#include "haptics/math/pose.h"
#include "haptics/math/wrench.h"

namespace fulcrum {

inline constexpr double kPortBound = -1e-4;  // J: below it the loop has made energy

class EnergyLedger {
public:
  // to_device: force_scale / position_scale.
  explicit EnergyLedger(double to_device) : to_device_(to_device) {}

  struct Port {
    Wrench F_H_W;  // on the handle about H over the tick before, in the scene's scale: rendered or not
    bool renders_torque = true;  // false: its torque was not rendered
    double weight = 0;           // J, potential energy of the tool now
    double springs = 0;          // J, energy in the coupling and in the tool's motion now
    bool open = false;           // the force is there in full
  };
  void book(const Pose& X_WH, const Port& port) noexcept;

  double port() const { return to_device_ * port_; }              // J, put in by the hand
  double unrendered() const { return to_device_ * unrendered_; }  // J, of that by turning against no torque

private:
  bool open_ = false;
  double to_device_;
  Pose last_X_WH_;
  double last_weight_ = 0;
  double port_ = 0, unrendered_ = 0;
};

}  // namespace fulcrum
