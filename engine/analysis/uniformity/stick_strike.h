#pragma once
// One strike of a stick on a ball, and what the hand feels of it: what the tick commands, less what moves the
// device's mass. "Compensating device inertia for 6-DOF haptic rendering", III.

#include <cstdint>

#include "engine/analysis/uniformity/stick_scene.h"
#include "haptics/world/world.h"

namespace fulcrum::analysis::uniformity {

inline constexpr double kTorqueLeast = 8e-3;  // N m, what nobody feels

struct StrikePath {
  double depth = 3e-3;      // m, at which is measured
  double beyond = 0.8e-3;   // m, how much deeper the hand would come to rest
  double acceleration = 1;  // m/s^2, up, against the motion
  double travel = 0.03;     // m, from rest to rest: half of it speeding up
  double tremor = 50e-6;    // m rms, each axis
  double held = 0.105;      // m along the stick, where the hand holds: between two places that are touched
};

struct StrikeOutcome {
  double depth = 0, force = 0, torque = 0;  // m; N, up; N m, about z at G
  double depth_error = 0;                   // m, of the depth that the contact found
  // N, up, of the passivity control: at the stage, as of a damper there. It is counted to the device.
  double resistance = 0;
  // Against the formulas for the force that the contact gave: over the predicted force; over the predicted
  // torque, or kTorqueLeast if that is more.
  double force_off = 0, torque_off = 0;
  bool limited = false;  // the device could not give all
};

// world: a stick_scene. seed: of the tremor, and of the phase of the encoder.
StrikeOutcome strike(World world, const StickTouch& touch, const StrikePath& path, InertiaMethod method,
                     std::uint64_t seed);

}  // namespace fulcrum::analysis::uniformity
