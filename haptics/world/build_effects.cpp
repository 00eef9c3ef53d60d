#include "haptics/world/build_effects.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {

std::optional<TorqueSubstitution> build_torque_substitution(const SceneDesc& desc) {
  if (!substitutes_torque(desc)) return std::nullopt;
  return TorqueSubstitution(
      *desc.torque_substitution,
      {.tick_s = desc.tick_s,
       .tool_reach = desc.tool_shell->max_radius_m,
       .max_force = desc.coupling.max_force,
       .max_torque = desc.coupling.max_torque,
       .renders_force = desc.device.renders_force,
       .senses_rotation = desc.device.senses_rotation,
       .springs = coupled(desc.contact.response) && desc.contact.response != ContactResponse::constraint});
}

std::optional<ImpactDetector> build_impact_detector(const SceneDesc& desc) {
  if (!detects_impacts(desc)) return std::nullopt;
  return ImpactDetector(desc.impact, desc.contact.region_radius, desc.scene_field, desc.scene_objects);
}

std::optional<ImpactVibration> build_impact_vibration(const SceneDesc& desc) {
  if (!vibrates_at_impacts(desc)) return std::nullopt;
  const Vec3 p_TH = desc.tool.X_HT.inverse().p;
  double reach = 0;
  for (const Vec3& p_T : desc.tool_shell->positions) reach = std::max(reach, (p_T - p_TH).norm());
  const DeviceDesc& device = desc.device;
  const double peak = figures_of(TransientSource::impact_vibration).peak;
  return ImpactVibration(*desc.impact_vibration,
                         {.tick_s = desc.tick_s,
                          .reach = reach,
                          .mapping = desc.mapping,
                          .largest_force = device.renders_force ? peak * device.max_force : 0.0,
                          .largest_torque = device.renders_torque ? peak * device.max_torque : 0.0,
                          .highest_Hz = highest_vibration(device.bandwidth_Hz, desc.tick_s)});
}

std::optional<BrakingPulse> build_braking_pulse(const SceneDesc& desc) {
  if (!brakes_at_impacts(desc)) return std::nullopt;
  return BrakingPulse(*desc.braking_pulse, desc.mapping, desc.tick_s);
}

std::optional<VibrotactileMotion> build_vibrotactile_motion(const SceneDesc& desc) {
  if (!moves_vibration(desc)) return std::nullopt;
  const auto& channels = desc.device.vibrotactile;
  return VibrotactileMotion(*desc.vibrotactile_motion, channels ? &*channels : nullptr,
                            desc.mapping.position_scale, desc.tick_s);
}

std::optional<HoldingPoint> build_holding_point(const SceneDesc& desc) {
  if (!desc.holding_point) return std::nullopt;
  HoldingPointDesc holding = *desc.holding_point;
  holding.measured = holding.measured && desc.device.strip;
  return HoldingPoint(holding, desc.device.strip, desc.tick_s);
}

std::optional<InertiaCompensation> build_inertia_compensation(const SceneDesc& desc) {
  if (!compensates_inertia(desc)) return std::nullopt;
  constexpr double share = 0.5;   // of the device's force: the other half is the scene's
  constexpr double exact = 1e-9;  // m rms, of a device whose position has no steps
  const DeviceDesc& device = desc.device;
  InertiaCompensationDesc compensation = *desc.inertia_compensation;
  compensation.filter.noise =
      std::max(exact, compensation.encoder_noise.value_or(device.encoder_step / std::sqrt(12.0)));
  return InertiaCompensation(compensation, {.tick_s = desc.tick_s,
                                            .mass = device.handle_mass,
                                            .damping = device.damping,
                                            .encoder_step = device.encoder_step,
                                            .largest_force = share * device.max_force});
}

}  // namespace fulcrum
