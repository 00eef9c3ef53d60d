#pragma once
// A passivity observer on the closed-loop port: the energy that the hand has put into the loop,
//     E_k = sum_j F_(j-1) . (x_j - x_(j-1)),   exact under a hold
// (B. Hannaford, J.-H. Ryu, "Time-domain passivity control of haptic interfaces", IEEE Trans. Robotics and Automation
// 18(1), 2002). The virtual tool's weight is a store that starts full: what it takes and gives is booked apart, as
// force_scale / position_scale * m g (height - first height). Below kPortBound the loop has made energy.

#include "haptics/math/pose.h"
#include "haptics/math/wrench.h"

namespace fulcrum {

inline constexpr double kPortBound = -1e-4;  // J

class EnergyLedger {
 public:
  // X_DH is where the handle is now, F_H_D what was commanded on it over the tick before (without what holds up the
  // device's own weight), stored J the energy in known stores now.
  void book(const Pose& X_DH, const Wrench& F_H_D, double stored) noexcept;

  double port() const { return port_; }  // J

 private:
  bool started_ = false;
  Pose last_X_DH_;
  double last_stored_ = 0;
  double port_ = 0;
};

}  // namespace fulcrum
