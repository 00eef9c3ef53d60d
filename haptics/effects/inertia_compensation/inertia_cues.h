#pragma once
// Compensation of a device's inertia, as the trace and the panel see it.

#include <cstdint>

#include "haptics/math/linear.h"

namespace fulcrum {

enum class InertiaMethod : std::int32_t { none, arm, acceleration };

// What one tick leaves behind.
struct InertiaCues {
  InertiaMethod method = InertiaMethod::none;
  double gain = 0;                     // of m a, that was in use
  bool faded = false;                  // it would have given more energy than it may
  Vec3 acceleration_D = Vec3::Zero();  // (3) m/s^2, of the handle, as estimated
  Vec3 force_D = Vec3::Zero();         // (3) N on the handle, what was commanded of it
  Vec3 torque_D = Vec3::Zero();        // (3) N m, what the method arm changed
  double energy = 0;                   // J, the account of acceleration, see InertiaCompensation
  double arm_energy = 0;               // J, that of arm
};

}  // namespace fulcrum
