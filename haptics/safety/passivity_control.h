#pragma once
// Takes back what the loop has made: a resistance against the handle's motion, on the axes that the device
// renders, for as long as the energy ledger tells of a deficit. After Hannaford and Ryu (2002), whose
// controller takes the whole deficit back within a tick; here it is spread over a stretch of the hand's way,
// because a handle whose encoder counts in steps stands still in most ticks:
//     F = -min((deficit - 1 uJ) / way, b |v|) v / |v|,    b a tenth of what would stop the handle within a
//     tick.
// The deficit thus settles where what is made per metre equals deficit / way.

#include "haptics/device/device.h"
#include "haptics/math/wrench.h"

namespace fulcrum {

class PassivityControl {
public:
  PassivityControl(const DeviceDesc& device, double tick_s);

  // deficit: J at the device, above 0 when the loop has made energy. v (6): the handle's motion in D, m and
  // rad per tick. Returns the wrench on the handle in D; zero when there is nothing to take back.
  Wrench resist(double deficit, const Vec6& per_tick) const noexcept;

private:
  bool force_, torque_;
  double tick_s_;
  double damping_, angular_damping_;  // N s/m, N m s
};

}  // namespace fulcrum
