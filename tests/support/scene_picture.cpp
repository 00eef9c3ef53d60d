#include "scene_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "haptics/effects/braking_pulse/braking_pulse_effect.h"
#include "haptics/effects/impact_vibration/impact_vibration_effect.h"
#include "haptics/effects/inertia_compensation/inertia_compensation_effect.h"
#include "haptics/effects/torque_substitution/torque_substitution_effect.h"
#include "haptics/effects/vibrotactile_motion/vibrotactile_motion_effect.h"
#include "image_compare.h"

namespace fulcrum::test {

app::FrameInput input_on_route(const app::Prepared& prepared, double time, std::size_t step) {
  const auto& hands = prepared.haptic.hands;
  const auto expert = std::ranges::find(hands, "expert", &scenario::HandScript::name);
  if (expert == hands.end()) throw std::runtime_error("the scenario has no expert hand");
  app::FrameInput input{};
  std::vector<std::optional<double>> reached(prepared.haptic.task.checkpoints.size());
  std::fill_n(reached.begin(), std::min(step, reached.size()), time);
  input.task = state_after(prepared.haptic.task, std::move(reached));
  input.task.time = time;
  input.task.inside = true;
  input.task.dwell_progress = 0.6;
  TickRecord& record = input.record;
  record.tick = static_cast<std::int64_t>(1000 * time);
  record.force_gain = 1;
  record.X_WT = HandPath(expert->waypoints).at(time);
  record.X_WH = record.X_WT * prepared.haptic.scene.tool.X_HT.inverse();
  record.coupling_F_T_W.torque = Vec3(0.02, 0, 0);
  record.device_F_H_D.force = Vec3(0.4, 0.3, 0);
  const SceneDesc& scene = prepared.haptic.scene;
  if (is_built<TorqueSubstitutionEffect>(scene, scene.torque_substitution)) {
    TorqueRecord& torque = record.torque_substitution.emplace();
    torque.vibration_gain = torque.ghost_gain = 1;
  }
  if (is_built<ImpactVibrationEffect>(scene, scene.impact_vibration))
    record.impact_vibration.emplace().gain = 1;
  if (is_built<BrakingPulseEffect>(scene, scene.braking_pulse)) {
    record.braking_pulse.emplace().gain = 1;
    record.braking_pulse->moment = true;
  }
  if (scene.holding_point) {
    HoldingRecord& holding = record.holding.emplace();
    holding.place = HandPath(expert->waypoints).grip(time).hold;
    holding.p_HG = holding.place * scene.holding_point->axis_H;
    holding.state = HoldingState::measured;
    holding.limit = 400;
    record.contact_stiffness = scene.contact.stiffness;
  }
  if (is_built<InertiaCompensationEffect>(scene, scene.inertia_compensation))
    record.inertia_compensation.emplace().method = InertiaMethod::acceleration;
  if (is_built<VibrotactileMotionEffect>(scene, scene.vibrotactile_motion)) {
    VibrotactileRecord& touch = record.vibrotactile_motion.emplace();
    touch.gain = 1;
    touch.command.level = {0.4 * scene.vibrotactile_motion->strength,
                           0.9 * scene.vibrotactile_motion->strength};
  }
  for (std::size_t motor = 0; motor < kMaxMotors; ++motor)
    record.actuator_load[motor] = 0.25 * static_cast<double>(motor) - 0.5;
  return input;
}

void turn_on(const app::Prepared& prepared, const Vec3& axis_T, double angle_rad, TickRecord& record) {
  const Quat q_WG = record.X_WT.q * Quat(Eigen::AngleAxisd(angle_rad, axis_T.normalized()));
  record.X_WH.q = q_WG * prepared.haptic.scene.tool.X_HT.q.conjugate();
  record.torque_substitution->bad = true;
  record.torque_substitution->vibration = 0.3;
  record.torque_substitution->ghost = 1;
}

void expect_golden(const app::Prepared& prepared, app::FrameInput input, const std::string& view,
                   const std::string& golden) {
  scenario::Checked<scenario::VisualAssembly> visual =
      scenario::assemble_visual(prepared.scenario, prepared.models, prepared.haptic.scene);
  ASSERT_TRUE(visual) << to_text(visual.faults());
  const auto found = std::ranges::find(visual->views, view, &scenario::View::name);
  ASSERT_NE(found, visual->views.end()) << view;
  input.camera = found->camera;
  app::RunOptions options;
  options.size = {640, 360};
  options.gpu = "llvmpipe";
  options.validate = true;
  const std::filesystem::path folder = FULCRUM_FAILURES;
  std::filesystem::create_directories(folder);
  const std::filesystem::path file = folder / (golden + ".png");
  const auto drawn =
      app::draw_picture(prepared, prepared.haptic.scene, *visual, input, options, file, nullptr);
  ASSERT_TRUE(drawn) << drawn.error().sentence;
  const auto picture = read_png(file);
  ASSERT_TRUE(picture) << picture.error().sentence;
  const Comparison comparison = compare(*picture, std::filesystem::path(FULCRUM_GOLDENS) / (golden + ".png"),
                                        {.failure_folder = folder});
  EXPECT_TRUE(comparison.passed) << comparison.sentence;
}

void expect_goldens(const app::Prepared& prepared, std::span<const Shot> shots) {
  for (const Shot& shot : shots)
    expect_golden(prepared, input_on_route(prepared, shot.time, shot.step), shot.view, shot.view);
}

void expect_ghost_goldens(const app::Prepared& prepared, std::span<const Shot> shots) {
  for (const Shot& shot : shots) {
    app::FrameInput input = input_on_route(prepared, shot.time, shot.step);
    turn_on(prepared, prepared.models.p_MT, 0.44, input.record);
    expect_golden(prepared, input, shot.view, std::string(shot.view) + "_ghost");
  }
}

}  // namespace fulcrum::test
