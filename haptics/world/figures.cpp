#include "haptics/world/figures.h"

#include <numbers>

#include "haptics/scene/figure_check.h"

namespace fulcrum {
namespace {

constexpr double kShortestTick = 1e-6, kLongestTick = 0.05;  // s
constexpr double kWholeTurn = 2 * std::numbers::pi;          // rad
constexpr double kLargestScale = 1e4;                        // of the scene to the device, either way

// Each of these takes its Desc apart into all of its members.

void check(FigureCheck& figures, const std::string& name, const JointDesc& joint) {
  const auto& [title, axis_K, point_K, home, low, high, max_torque, through_parallelogram] = joint;
  figures.direction(name + ".axis", axis_K);
  figures.finite(name + ".point", point_K);
  figures.from_to(name + ".home", home, -kWholeTurn, kWholeTurn);
  figures.from_to(name + ".low", low, -kWholeTurn, kWholeTurn);
  figures.from_to(name + ".high", high, -kWholeTurn, kWholeTurn);
  figures.at_least(name + ".max_torque", max_torque);
}

void check(FigureCheck& figures, const MechanismDesc& mechanism) {
  const auto& [q_DK, arms, spin] = mechanism;
  figures.rotation("device.base.orientation", q_DK);
  for (const ArmDesc& arm : arms) {
    const auto& [name, joints, end_K] = arm;
    for (const JointDesc& joint : joints) check(figures, "device.arms." + name + "." + joint.name, joint);
    figures.finite("device.arms." + name + ".end", end_K);
  }
  if (!spin) return;
  const auto& [name, ratio, max_torque] = *spin;
  figures.above("device.spin.ratio", ratio);
  figures.at_least("device.spin.max_torque", max_torque);
}

void check(FigureCheck& figures, const StructureDesc& structure) {
  const auto& [tip_stiffness, angular_stiffness_H] = structure;
  figures.above("device.structure.tip_stiffness", tip_stiffness);
  figures.above("device.structure.angular_stiffness", angular_stiffness_H);
}

void check(FigureCheck& figures, const VibrotactileDesc& vibrotactile) {
  const auto& [channels] = vibrotactile;
  for (const ChannelDesc& channel : channels) {
    const auto& [title, kind, largest, rate_Hz, resonance_Hz, quality, lag] = channel;
    const std::string name = "device.vibrotactile." + title;
    const bool pcm = kind == ChannelKind::pcm;
    figures.above(name + ".largest", largest);
    figures.above_to(name + ".rate_Hz", rate_Hz, 0, FigureCheck::kFastest_Hz);
    figures.at_least(name + ".resonance_Hz", resonance_Hz);
    figures.at_least(name + ".quality", quality);
    if (pcm) figures.above(name + ".resonance_Hz", resonance_Hz);
    if (pcm) figures.above(name + ".quality", quality, 0.5);
    figures.from_to(name + ".lag", lag, 0, FigureCheck::kLongestTime);
  }
}

void check(FigureCheck& figures, const HoldingStripDesc& strip) {
  const auto& [low_place, high_place, low_ohm, high_ohm, closing_force, opening_force, noise_ohm,
               dropout_rate, dropout_length, tolerance] = strip;
  const std::string name = "device.strip";
  figures.finite(name + ".low_place", low_place);
  figures.finite(name + ".high_place", high_place);
  figures.at_least(name + ".low_ohm", low_ohm);
  figures.at_least(name + ".high_ohm", high_ohm);
  figures.at_least(name + ".closing_force", closing_force);
  figures.at_least(name + ".opening_force", opening_force);
  figures.at_least(name + ".noise_ohm", noise_ohm);
  figures.at_least(name + ".dropout_rate", dropout_rate);
  figures.from_to(name + ".dropout_length", dropout_length, 0, FigureCheck::kLongestTime);
  figures.from_to(name + ".tolerance", tolerance, 0, 1);
}

void check(FigureCheck& figures, const DeviceDesc& device) {
  const auto& [name, kinematics, renders_force, renders_torque, senses_rotation, max_force, max_torque,
               handle_mass, handle_inertia, handle_weight, bandwidth_Hz, damping, angular_damping, friction,
               angular_friction, encoder_step, encoder_step_rad, sample_rate_Hz, firmware_watchdog, workspace,
               workspace_centre, mechanism, structure, vibrotactile, strip] = device;
  figures.at_least("device.max_force", max_force);
  figures.at_least("device.max_torque", max_torque);
  figures.above("device.handle_mass", handle_mass);
  figures.above("device.handle_inertia", handle_inertia);
  figures.at_least("device.handle_weight", handle_weight);
  figures.above("device.bandwidth_Hz", bandwidth_Hz);
  figures.at_least("device.damping", damping);
  figures.at_least("device.angular_damping", angular_damping);
  figures.at_least("device.friction", friction);
  figures.at_least("device.angular_friction", angular_friction);
  figures.at_least("device.encoder_step", encoder_step);
  figures.at_least("device.encoder_step_rad", encoder_step_rad);
  figures.from_to("device.sample_rate_Hz", sample_rate_Hz, 0, FigureCheck::kFastest_Hz);
  figures.from_to("device.firmware_watchdog", firmware_watchdog, 0, FigureCheck::kLongestTime);
  figures.at_least("device.workspace", workspace);
  figures.finite("device.workspace_centre", workspace_centre);
  if (kinematics == Kinematics::arms) check(figures, mechanism);
  if (structure) check(figures, *structure);
  if (vibrotactile) check(figures, *vibrotactile);
  if (strip) check(figures, *strip);
}

void check(FigureCheck& figures, const MappingDesc& mapping) {
  const auto& [X_WD, position_scale, force_scale, engages_at_start, clutch_button, drift] = mapping;
  figures.pose("device.base", X_WD);
  figures.from_to("device.position_scale", position_scale, 1 / kLargestScale, kLargestScale);
  figures.from_to("device.force_scale", force_scale, 1 / kLargestScale, kLargestScale);
  figures.from_to("device.clutch_button", clutch_button, -1, 31);
  figures.from_to("device.drift", drift, 0, MappingDesc::kMostDrift);
}

void check(FigureCheck& figures, const ToolDesc& tool) {
  const auto& [mass, inertia_T, X_HT, X_WT_start, weight] = tool;
  figures.above("tool.mass", mass);
  figures.symmetric("tool.inertia", inertia_T);
  figures.pose("tool.grasp", X_HT);
  figures.pose("tool.start", X_WT_start);
}

void check(FigureCheck& figures, const ContactDesc& contact) {
  const auto& [response, stiffness, levels, dissipation, friction, torsional_friction, rolling_friction,
               region_radius] = contact;
  figures.above("contact.stiffness", stiffness);
  for (const double level : levels) figures.above("contact.levels", level);
  figures.at_least("contact.dissipation", dissipation);
  figures.at_least("contact.friction", friction);
  figures.at_least("contact.torsional_friction", torsional_friction);
  figures.at_least("contact.rolling_friction", rolling_friction);
  figures.above("contact.region_radius", region_radius);
}

void check(FigureCheck& figures, const CouplingDesc& coupling) {
  const auto& [stiffness, angular_stiffness, damping_ratio, max_force, max_torque] = coupling;
  figures.above("coupling.stiffness", stiffness);
  figures.above("coupling.angular_stiffness", angular_stiffness);
  figures.from_to("coupling.damping_ratio", damping_ratio, 0, 1);
  figures.above("coupling.max_force", max_force);
  figures.above("coupling.max_torque", max_torque);
}

void check(FigureCheck& figures, const VelocityEstimatorDesc& velocity) {
  const auto& [kind, cutoff_Hz, window, noise, noise_rad] = velocity;
  figures.above("velocity.cutoff_Hz", cutoff_Hz);
  figures.from_to("velocity.window", window, 1, 1000);
  figures.at_least("velocity.noise", noise);
  figures.at_least("velocity.noise_rad", noise_rad);
}

void check(FigureCheck& figures, const HoldingPointDesc& holding) {
  const auto& [axis_H, place, low, high, measured, speed, settle, stillness, margin, smoothing, keep, fade] =
      holding;
  const std::string name = "holding_point";
  figures.unit(name + ".axis", axis_H);
  figures.finite(name + ".low", low);
  figures.finite(name + ".high", high);
  figures.finite(name + ".place", place);
  figures.above(name + ".speed", speed);
  figures.from_to(name + ".settle", settle, 0, FigureCheck::kLongestTime);
  figures.at_least(name + ".stillness", stillness);
  figures.at_least(name + ".margin", margin);
  figures.from_to(name + ".smoothing", smoothing, 0, FigureCheck::kLongestTime);
  figures.from_to(name + ".keep", keep, 0, FigureCheck::kLongestTime);
  figures.above_to(name + ".fade", fade, 0, FigureCheck::kLongestTime);
}

}  // namespace

std::optional<Error> refuse_figures(const SceneDesc& desc) {
  const auto& [tick_s, tool, tool_shell, scene_field, scene_edges, tool_field, tool_features, scene_features,
               contact, integrator, coupling, velocity, mapping, device, allocation, impact, scene_objects,
               holding_point] = static_cast<const PlainScene&>(desc);
  FigureCheck figures;
  figures.from_to("The tick", tick_s, kShortestTick, kLongestTick);
  check(figures, tool);
  check(figures, contact);
  check(figures, coupling);
  check(figures, velocity);
  check(figures, mapping);
  check(figures, device);
  const auto& [method, moment_weight] = allocation;
  figures.above("device.allocation.moment_weight", moment_weight);
  const auto& [retreat, least_speed] = impact;
  figures.above("impact.retreat", retreat);
  figures.at_least("impact.least_speed", least_speed);
  if (holding_point) check(figures, *holding_point);
  check_effects(figures, desc);
  return figures.error();
}

}  // namespace fulcrum
