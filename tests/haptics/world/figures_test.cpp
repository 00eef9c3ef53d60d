// No figure of a scene that is no number gets into a World.

#include "haptics/world/figures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

#include "haptics/world/world.h"
#include "tests/haptics/actuation/w6d.h"
#include "tests/haptics/scenes.h"

namespace fulcrum::test {
namespace {

// One with everything.
SceneDesc full_scene() {
  SceneDesc desc = floor_scene({Vec3::Zero()}, 0.02);
  desc.device = w6d::device(0.5, 0.1);
  desc.device.structure = StructureDesc{.tip_stiffness = 1000, .angular_stiffness_H = Vec3::Ones()};
  desc.device.strip = HoldingStripDesc{};
  desc.device.vibrotactile =
      VibrotactileDesc{{{.name = "left", .largest = 10, .resonance_Hz = 200, .quality = 2},
                        {.name = "right", .kind = ChannelKind::rumble, .largest = 10}}};
  desc.contact.levels = {100, 200};
  desc.torque_substitution = TorqueSubstitutionDesc{.bad_above = 0.02,
                                                    .tool_radius = 0.05,
                                                    .limit_stiffness = false,
                                                    .reference = 0.02,
                                                    .ghost_above = 0.04,
                                                    .ghost_below = 0.03};
  desc.impact_vibration.emplace();
  desc.braking_pulse.emplace();
  desc.vibrotactile_motion.emplace();
  desc.holding_point.emplace();
  desc.inertia_compensation = InertiaCompensationDesc{.encoder_noise = 1e-6};
  desc.workspace_walls = WorkspaceWallsDesc{.margin = 0.01, .stiffness = 50};
  desc.coupling = {.stiffness = 200, .angular_stiffness = 0.05};
  return desc;
}

struct Figure {
  std::string name;  // as the sentence has it
  std::function<double&(SceneDesc&)> of;
};

#define FIGURE(name, expression)                             \
  Figure {                                                   \
    name, [](SceneDesc& s) -> double& { return expression; } \
  }

std::vector<Figure> figures_of_scene_and_device() {
  return {
      FIGURE("The tick", s.tick_s),
      FIGURE("tool.mass", s.tool.mass),
      FIGURE("tool.inertia", s.tool.inertia_T(1, 2)),
      FIGURE("tool.grasp.position", s.tool.X_HT.p.y()),
      FIGURE("tool.grasp.orientation", s.tool.X_HT.q.z()),
      FIGURE("tool.start.position", s.tool.X_WT_start.p.z()),
      FIGURE("contact.stiffness", s.contact.stiffness),
      FIGURE("contact.levels", s.contact.levels[1]),
      FIGURE("contact.dissipation", s.contact.dissipation),
      FIGURE("contact.friction", s.contact.friction),
      FIGURE("contact.region_radius", s.contact.region_radius),
      FIGURE("coupling.stiffness", s.coupling.stiffness),
      FIGURE("coupling.angular_stiffness", s.coupling.angular_stiffness),
      FIGURE("coupling.damping_ratio", s.coupling.damping_ratio),
      FIGURE("coupling.max_force", s.coupling.max_force),
      FIGURE("coupling.max_torque", s.coupling.max_torque),
      FIGURE("velocity.cutoff_Hz", s.velocity.cutoff_Hz),
      FIGURE("velocity.noise", s.velocity.noise),
      FIGURE("velocity.noise_rad", s.velocity.noise_rad),
      FIGURE("device.base.position", s.mapping.X_WD.p.x()),
      FIGURE("device.base.orientation", s.mapping.X_WD.q.w()),
      FIGURE("device.position_scale", s.mapping.position_scale),
      FIGURE("device.force_scale", s.mapping.force_scale),
      FIGURE("device.drift", s.mapping.drift),
      FIGURE("device.max_force", s.device.max_force),
      FIGURE("device.max_torque", s.device.max_torque),
      FIGURE("device.handle_mass", s.device.handle_mass),
      FIGURE("device.handle_inertia", s.device.handle_inertia.y()),
      FIGURE("device.handle_weight", s.device.handle_weight),
      FIGURE("device.bandwidth_Hz", s.device.bandwidth_Hz),
      FIGURE("device.damping", s.device.damping),
      FIGURE("device.angular_damping", s.device.angular_damping.z()),
      FIGURE("device.friction", s.device.friction),
      FIGURE("device.angular_friction", s.device.angular_friction),
      FIGURE("device.encoder_step", s.device.encoder_step),
      FIGURE("device.encoder_step_rad", s.device.encoder_step_rad),
      FIGURE("device.sample_rate_Hz", s.device.sample_rate_Hz),
      FIGURE("device.firmware_watchdog", s.device.firmware_watchdog),
      FIGURE("device.workspace", s.device.workspace.x()),
      FIGURE("device.workspace_centre", s.device.workspace_centre.y()),
      FIGURE("device.base.orientation", s.device.mechanism.q_DK.x()),
      FIGURE("axis", s.device.mechanism.arms[0].joints[1].axis_K.y()),
      FIGURE("point", s.device.mechanism.arms[1].joints[2].point_K.z()),
      FIGURE("home", s.device.mechanism.arms[0].joints[0].home),
      FIGURE("low", s.device.mechanism.arms[0].joints[0].low),
      FIGURE("high", s.device.mechanism.arms[0].joints[0].high),
      FIGURE("max_torque", s.device.mechanism.arms[0].joints[2].max_torque),
      FIGURE("end", s.device.mechanism.arms[1].end_K.x()),
      FIGURE("device.spin.ratio", s.device.mechanism.spin->ratio),
      FIGURE("device.spin.max_torque", s.device.mechanism.spin->max_torque),
      FIGURE("device.structure.tip_stiffness", s.device.structure->tip_stiffness),
      FIGURE("device.structure.angular_stiffness", s.device.structure->angular_stiffness_H.x()),
      FIGURE("device.vibrotactile.left.largest", s.device.vibrotactile->channels[0].largest),
      FIGURE("device.vibrotactile.left.rate_Hz", s.device.vibrotactile->channels[0].rate_Hz),
      FIGURE("device.vibrotactile.left.resonance_Hz", s.device.vibrotactile->channels[0].resonance_Hz),
      FIGURE("device.vibrotactile.left.quality", s.device.vibrotactile->channels[0].quality),
      FIGURE("device.vibrotactile.right.lag", s.device.vibrotactile->channels[1].lag),
      FIGURE("device.strip.low_place", s.device.strip->low_place),
      FIGURE("device.strip.high_ohm", s.device.strip->high_ohm),
      FIGURE("device.strip.dropout_length", s.device.strip->dropout_length),
      FIGURE("device.allocation.moment_weight", s.allocation.moment_weight),
      FIGURE("impact.retreat", s.impact.retreat),
      FIGURE("impact.least_speed", s.impact.least_speed),
  };
}

std::vector<Figure> figures_of_effects() {
  return {
      FIGURE("torque_substitution.bad_above", *s.torque_substitution->bad_above),
      FIGURE("torque_substitution.tool_radius", *s.torque_substitution->tool_radius),
      FIGURE("torque_substitution.vibration.gain", s.torque_substitution->vibration_gain),
      FIGURE("torque_substitution.vibration.amplitude", s.torque_substitution->amplitude),
      FIGURE("torque_substitution.vibration.frequency_Hz", s.torque_substitution->frequency_Hz),
      FIGURE("torque_substitution.vibration.reference", *s.torque_substitution->reference),
      FIGURE("torque_substitution.ghost.gain", s.torque_substitution->ghost_gain),
      FIGURE("torque_substitution.ghost.above", *s.torque_substitution->ghost_above),
      FIGURE("torque_substitution.ghost.below", *s.torque_substitution->ghost_below),
      FIGURE("torque_substitution.ghost.fade", s.torque_substitution->ghost_fade),
      FIGURE("impact_vibration.gain", s.impact_vibration->gain),
      FIGURE("impact_vibration.hand_stiffness", s.impact_vibration->hand_stiffness),
      FIGURE("attack", s.impact_vibration->materials[0].attack),
      FIGURE("decay", s.impact_vibration->materials[0].decay),
      FIGURE("frequency_Hz", s.impact_vibration->materials[0].frequency_Hz),
      FIGURE("braking_pulse.hand_mass", s.braking_pulse->hand_mass),
      FIGURE("braking_pulse.grasp", s.braking_pulse->p_HG.z()),
      FIGURE("braking_pulse.gain", s.braking_pulse->gain),
      FIGURE("vibrotactile_motion.window", s.vibrotactile_motion->law.window),
      FIGURE("vibrotactile_motion.reference", s.vibrotactile_motion->law.reference),
      FIGURE("vibrotactile_motion.strength", s.vibrotactile_motion->strength),
      FIGURE("vibrotactile_motion.update_Hz", s.vibrotactile_motion->update_Hz),
      FIGURE("vibrotactile_motion.carrier_Hz", s.vibrotactile_motion->carrier_Hz),
      FIGURE("vibrotactile_motion.gain", s.vibrotactile_motion->gain),
      FIGURE("vibrotactile_motion.centre", s.vibrotactile_motion->centre_W.x()),
      FIGURE("vibrotactile_motion.axis", s.vibrotactile_motion->axis_W.y()),
      FIGURE("vibrotactile_motion.lateral_force", s.vibrotactile_motion->lateral_force),
      FIGURE("vibrotactile_motion.full_speed", s.vibrotactile_motion->full_speed),
      FIGURE("vibrotactile_motion.full_force", s.vibrotactile_motion->full_force),
      FIGURE("holding_point.axis", s.holding_point->axis_H.x()),
      FIGURE("holding_point.place", s.holding_point->place),
      FIGURE("holding_point.low", s.holding_point->low),
      FIGURE("holding_point.high", s.holding_point->high),
      FIGURE("holding_point.speed", s.holding_point->speed),
      FIGURE("holding_point.settle", s.holding_point->settle),
      FIGURE("holding_point.smoothing", s.holding_point->smoothing),
      FIGURE("holding_point.keep", s.holding_point->keep),
      FIGURE("holding_point.fade", s.holding_point->fade),
      FIGURE("inertia_compensation.gain", s.inertia_compensation->gain),
      FIGURE("inertia_compensation.budget", s.inertia_compensation->budget),
      FIGURE("inertia_compensation.filter.jerk", s.inertia_compensation->filter.jerk),
      FIGURE("inertia_compensation.filter.noise", s.inertia_compensation->filter.noise),
      FIGURE("inertia_compensation.filter.jerk_time", s.inertia_compensation->filter.jerk_time),
      FIGURE("inertia_compensation.filter.adapt_time", s.inertia_compensation->filter.adapt_time),
      FIGURE("inertia_compensation.filter.range", s.inertia_compensation->filter.range),
      FIGURE("inertia_compensation.encoder_noise", *s.inertia_compensation->encoder_noise),
      FIGURE("device.workspace_walls.margin", *s.workspace_walls->margin),
      FIGURE("device.workspace_walls.stiffness", *s.workspace_walls->stiffness),
  };
}

std::vector<Figure> figures() {
  std::vector<Figure> all = figures_of_scene_and_device();
  std::ranges::move(figures_of_effects(), std::back_inserter(all));
  return all;
}

TEST(Figures, TheSceneWithEverythingIsBuilt) {
  const Result<World> world = World::build(full_scene());
  EXPECT_TRUE(world) << world.error().sentence;
}

TEST(Figures, WhatIsNoNumberIsRefusedByName) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const Figure& figure : figures()) {
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity, 1e300}) {
      SceneDesc desc = full_scene();
      figure.of(desc) = bad;
      const Result<World> world = World::build(desc);
      ASSERT_FALSE(world) << figure.name << " = " << bad;
      EXPECT_NE(world.error().sentence.find(figure.name), std::string::npos) << world.error().sentence;
    }
  }
}

TEST(Figures, WhatIsOutOfRangeIsRefusedWithTheRange) {
  SceneDesc desc = full_scene();
  desc.device.max_force = -1;
  EXPECT_EQ(World::build(desc).error().sentence, "device.max_force is -1; it must be 0 or more.");
  desc = full_scene();
  desc.coupling.damping_ratio = 1.5;
  EXPECT_EQ(World::build(desc).error().sentence, "coupling.damping_ratio is 1.5; it must be from 0 to 1.");
  desc = full_scene();
  desc.tool.inertia_T(0, 1) += 1e-3 * desc.tool.inertia_T.norm();
  EXPECT_NE(World::build(desc).error().sentence.find("the asymmetry of tool.inertia"), std::string::npos);
  desc = full_scene();
  desc.braking_pulse->ticks = 0;
  EXPECT_EQ(World::build(desc).error().sentence, "braking_pulse.ticks is 0; it must be from 1 to 50.");
}

}  // namespace
}  // namespace fulcrum::test
