#pragma once
// What stiffness a device can be given of a coupling, and a coupling that suits a device.
//
// The handle, in no hand, against a tool that the scene holds still and, where it has a mass, against one
// that nothing holds: the exact linear loop of device/linear_loop.h, with the device's mass and damping, the
// tick, the delay of the velocity estimator, the scales of the mapping and the coupling's own damper. A hand
// adds damping, so what is stable in none is stable in most.

#include <optional>
#include <string>

#include "haptics/scene/plain_scene.h"

namespace fulcrum {

// N/m and N m/rad, as the coupling counts them; infinite where the device has no motors for it. The damper is
// that of desc.coupling.damping_ratio at each stiffness.
struct StiffnessLimits {
  double stiffness;
  double angular_stiffness;
};
StiffnessLimits coupling_limits(const PlainScene& desc);

// What a scenario gives of its coupling. The rest follows from the device.
struct CouplingGains {
  std::optional<double> stiffness;          // N/m
  std::optional<double> angular_stiffness;  // N m/rad
  double damping_ratio = CouplingDesc{}.damping_ratio;
  std::optional<double> max_force;   // N
  std::optional<double> max_torque;  // N m
};

// Where not given: half of the limit of stiffness, and where the device has friction, no more than it holds
// still from one encoder count to the next, 2 f_c / D (Diolaiti et al., IEEE Trans. Robotics 22(2), 2006). As
// much angular stiffness as lets the tool turn as fast as it moves, within the same limits. Springs that
// saturate just below the device's limits. desc: all but its coupling.
CouplingDesc tune_coupling(const CouplingGains& given, const PlainScene& desc);

// A sentence if a stiffness is beyond its limit.
std::optional<std::string> beyond_limits(const PlainScene& desc);

// N s/m in the scene, of a damper on the handle without a spring, up to which the same loop is stable;
// infinite where the device does not push.
double damping_limit(const PlainScene& desc);

}  // namespace fulcrum
