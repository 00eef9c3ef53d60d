#include "haptics/safety/passivity_controller.h"

#include <algorithm>

namespace fulcrum {
namespace {

constexpr double kIgnored = 1e-6;  // J, what rounding and a single count make, which nobody feels
constexpr double kTravel = 1e-4;   // m of the handle's travel, over which generated energy is taken back
constexpr double kTurn = 2e-3;     // rad, the same for a turn
constexpr double kUncertainTravel = 1e-3;  // m, over which energy that may have been generated is taken back
constexpr double kUncertainTurn = 2e-2;    // rad, the same for a turn
constexpr double kBrakeShare = 0.1;        // of what would stop the handle within a tick
constexpr double kFrictionShare = 0.02;    // of the device's largest force and torque

Vec3 against(const Vec3& v, double most, double damping) {
  const double speed = v.norm();
  if (!(speed > 0)) return Vec3::Zero();
  return v * (-std::min(most / speed, damping));
}

}  // namespace

PassivityController::PassivityController(const DeviceDesc& device, double tick_s)
    : force_(device.renders_force),
      torque_(device.renders_torque),
      tick_s_(tick_s),
      damping_(kBrakeShare * device.handle_mass / tick_s),
      angular_damping_(kBrakeShare * device.handle_inertia.minCoeff() / tick_s),
      friction_(kFrictionShare * device.max_force),
      angular_friction_(kFrictionShare * device.max_torque) {}

Wrench PassivityController::resist(const Deficit& deficit, const Vec6& per_tick) const noexcept {
  Wrench F_H_D;
  const double made = std::max(0.0, deficit.made - kIgnored), unknown = std::max(0.0, deficit.unknown);
  if (!(made + unknown > kIgnored)) return F_H_D;
  const Vec6 V = per_tick / tick_s_;
  if (force_)
    F_H_D.force =
        against(V.head<3>(), made / kTravel + std::min(unknown / kUncertainTravel, friction_), damping_);
  if (torque_)
    F_H_D.torque = against(V.tail<3>(), made / kTurn + std::min(unknown / kUncertainTurn, angular_friction_),
                           angular_damping_);
  return F_H_D;
}

}  // namespace fulcrum
