#pragma once
// Takes back what the loop has made: a resistance against the handle's motion, on the axes that the device
// renders, for as long as the passivity observer tells of a deficit. After Hannaford and Ryu (2002), whose
// controller takes the whole deficit back within a tick; here it is spread over a stretch of the hand's way,
// because a handle whose encoder counts in steps stands still in most ticks:
//     F = -min((made - 1 uJ) / way + min(unknown / long_way, f), b |v|) v / |v|
// with b a tenth of what would stop the handle within a tick. What has been made, as far as counts can tell,
// is taken back within a tenth of a millimetre. What they only leave open (counted_work.h) is taken back over
// a millimetre, by a friction f of at most 2 % of the device's largest force, which is hardly felt. Where
// both settle, as much is taken back per metre as is made or left open.

#include "haptics/device/device.h"
#include "haptics/math/wrench.h"

namespace fulcrum {

class PassivityController {
public:
  PassivityController(const DeviceDesc& device, double tick_s);

  struct Deficit {       // J at the device
    double made = 0;     // above 0 when the loop has made energy, as far as counts can tell
    double unknown = 0;  // what it may have made beyond that
  };
  // per_tick (6): the handle's motion in D, m and rad. Returns the wrench on the handle in D; zero when there
  // is nothing to take back.
  Wrench resist(const Deficit& deficit, const Vec6& per_tick) const noexcept;

private:
  bool force_, torque_;
  double tick_s_;
  double damping_, angular_damping_;    // N s/m, N m s
  double friction_, angular_friction_;  // N, N m
};

}  // namespace fulcrum
