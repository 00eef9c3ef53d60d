#pragma once
// What compensation and control point are to do, by the algebra and by the device's own Jacobians.

#include "haptics/device/device.h"

namespace fulcrum::analysis::uniformity {

struct InertiaChecks {
  // Under a control point that is not the hand's: J_true^-T J_used^T F, of the device's own Jacobians,
  // against the same wrench moved from one to the other, over its size; largest of 2000 random cases.
  double control_point = 0;
  // N m, with m .25 kg, a 1 m/s^2, f 1 N, all across the stick, h .03 m and l .1 m.
  double wanted = 0, uncompensated = 0, as_printed = 0;
};

// device: for the control point an arm of six; of others it is not checked and stays 0.
InertiaChecks check_inertia(const DeviceDesc& device);

}  // namespace fulcrum::analysis::uniformity
