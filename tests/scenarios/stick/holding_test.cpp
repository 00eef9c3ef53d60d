// The panel of the holding point and what presses on it ask for; the axes where the hand holds.

#include <gtest/gtest.h>

#include "engine/app/picture/bridge.h"
#include "engine/app/picture/holding_controls.h"
#include "engine/scenario/followed.h"

namespace fulcrum::test {
namespace {

using Kind = Command::Kind;
using Part = ui::HoldingPress::Part;

SceneDesc stick_scene() {
  SceneDesc scene;
  scene.contact.levels = {100, 200, 300};
  scene.contact.stiffness = 200;
  scene.contact.response = ContactResponse::direct;
  scene.device.strip.emplace();
  scene.device.structure.emplace();
  scene.device.renders_torque = true;
  scene.holding_point = HoldingPointDesc{.place = 0.1, .low = 0.03, .high = 0.17};
  scene.inertia_compensation.emplace();
  return scene;
}

TickRecord held(double place, HoldingState state) {
  TickRecord record;
  record.X_WT = {Quat(Eigen::AngleAxisd(0.4, Vec3::UnitZ())), Vec3(0.1, 0.2, 0.3)};
  record.holding.emplace();
  record.holding->place = place;
  record.holding->p_HG = Vec3(place, 0, 0);
  record.holding->state = state;
  record.holding->limit = 316;
  record.inertia_compensation.emplace().method = InertiaMethod::arm;
  record.contact_stiffness = 300;
  return record;
}

ui::HoldingPanel shown(HoldingState state) {
  return *app::holding_panel(stick_scene(), held(0.084, state));
}

TEST(Holding, PanelShowsTheTickAndSaysWhatTheStripDoes) {
  EXPECT_FALSE(app::holding_panel(SceneDesc{}, held(0.1, HoldingState::set)));
  const ui::HoldingPanel panel = shown(HoldingState::measured);
  EXPECT_EQ(panel.place, 0.084);
  EXPECT_EQ(panel.stiffness, 300);
  EXPECT_TRUE(panel.structure_known);
  EXPECT_EQ(panel.limit, 316);
  EXPECT_EQ(panel.methods[panel.method], "arm");
  EXPECT_TRUE(panel.measured);
  EXPECT_TRUE(panel.sensed_well);
  EXPECT_NE(panel.sensed.find("84 mm"), std::string::npos);
  for (const HoldingState lost : {HoldingState::kept, HoldingState::fading, HoldingState::lost}) {
    EXPECT_FALSE(shown(lost).sensed_well);
    EXPECT_TRUE(shown(lost).sensed.starts_with("lost"));
  }
}

TEST(Holding, PanelOffersOnlyMethodsThatDoSomething) {
  SceneDesc scene = stick_scene();
  const TickRecord record = held(0.1, HoldingState::set);
  const auto next = [&] {
    return app::holding_commands(*app::holding_panel(scene, record), app::HoldingKey::method);
  };
  const std::vector<Command> to_none{{Kind::compensation, 0}}, to_acceleration{{Kind::compensation, 2}};
  EXPECT_EQ(next(), to_acceleration);  // from arm
  scene.device.renders_torque = false;
  EXPECT_EQ(app::holding_panel(scene, record)->methods, (std::vector<std::string>{"none", "acceleration"}));
  EXPECT_EQ(app::holding_panel(scene, record)->method, 0U);
  EXPECT_EQ(next(), to_acceleration);
  scene.device.renders_torque = true;
  scene.inertia_compensation->gain = 0;
  EXPECT_EQ(next(), to_none);
  TickRecord off = record;
  off.inertia_compensation->method = InertiaMethod::acceleration;
  const ui::HoldingPanel panel = *app::holding_panel(scene, off);
  EXPECT_EQ(panel.methods[panel.method], "none");
  scene.inertia_compensation->switchable = false;
  EXPECT_EQ(app::holding_panel(scene, off)->methods, (std::vector<std::string>{"none"}));
}

TEST(Holding, ALevelThatIsAskedForWhilePressingIsPendingAndAddsUp) {
  const SceneDesc scene = stick_scene();
  TickRecord record = held(0.1, HoldingState::set);
  record.contact_stiffness = 100;
  record.contact_stiffness_wanted = 100;
  EXPECT_FALSE(app::holding_panel(scene, record)->pending);
  for (const double wanted : {200.0, 300.0}) {
    const std::vector<Command> step =
        app::holding_commands(*app::holding_panel(scene, record), app::HoldingKey::stiffer);
    EXPECT_EQ(step, (std::vector<Command>{{Kind::contact_stiffness, wanted}}));
    record.contact_stiffness_wanted = wanted;
    EXPECT_EQ(app::holding_panel(scene, record)->pending, wanted);
    EXPECT_EQ(app::holding_panel(scene, record)->stiffness, 100);
  }
}

TEST(Holding, PanelOfAConstraintHasNoStiffness) {
  SceneDesc scene = stick_scene();
  scene.contact.levels.clear();
  scene.contact.response = ContactResponse::constraint;
  TickRecord record = held(0.1, HoldingState::set);
  record.contact_stiffness.reset();
  EXPECT_FALSE(app::holding_panel(scene, record)->stiffness);
}

TEST(Holding, WhatAPersonSaysIsNotOverruledByTheStrip) {
  const std::vector<Command> expected{{Kind::hold_measured, 0}, {Kind::hold_at, 0.12}};
  EXPECT_EQ(app::holding_commands(shown(HoldingState::measured), {Part::place, 0.12}), expected);
  const std::vector<Command> told{{Kind::hold_at, 0.12}};
  EXPECT_EQ(app::holding_commands(shown(HoldingState::set), {Part::place, 0.12}), told);
}

TEST(Holding, KeysGoStepByStepAndStayInRange) {
  const auto asked = [](const ui::HoldingPanel& panel, app::HoldingKey key) {
    const std::vector<Command> commands = app::holding_commands(panel, key);
    return commands.empty() ? Command{} : commands.back();
  };
  ui::HoldingPanel panel = shown(HoldingState::set);
  EXPECT_NEAR(asked(panel, app::HoldingKey::nearer).value, 0.079, 1e-12);
  EXPECT_NEAR(asked(panel, app::HoldingKey::farther).value, 0.089, 1e-12);
  panel.place = 0.168;
  EXPECT_EQ(asked(panel, app::HoldingKey::farther).value, 0.17);
  EXPECT_EQ(asked(panel, app::HoldingKey::softer), (Command{Kind::contact_stiffness, 200}));
  EXPECT_EQ(asked(panel, app::HoldingKey::stiffer), (Command{Kind::contact_stiffness, 300}));
  EXPECT_EQ(asked(panel, app::HoldingKey::method), (Command{Kind::compensation, 2}));
  panel.method = 2;
  EXPECT_EQ(asked(panel, app::HoldingKey::method), (Command{Kind::compensation, 0}));
  EXPECT_EQ(asked(panel, app::HoldingKey::measured), (Command{Kind::hold_measured, 1}));
  panel.levels.clear();
  EXPECT_TRUE(app::holding_commands(panel, app::HoldingKey::stiffer).empty());
}

TEST(Holding, AxesAreAtTheHoldingPointAndTurnWithTheStick) {
  const std::optional<app::Prepared> stick = app::prepare("stick", std::vector<std::string>());
  ASSERT_TRUE(stick);
  const SceneDesc& scene = stick->haptic.scene;
  const auto visual = scenario::assemble_visual(stick->scenario, stick->models, scene);
  ASSERT_TRUE(visual) << scenario::to_text(visual.faults());
  app::FrameBridge bridge(visual->desc, stick->scenario, scene);
  const TickRecord record = held(0.084, HoldingState::measured);
  TickRecord posed = record;
  posed.X_WH = scene.mapping.X_WD;
  const render::FrameState frame = bridge.frame(posed, {}, {}, {}, 0);
  const Vec3 expected = record.X_WT * (scene.tool.X_HT.inverse() * Vec3(0.084, 0, 0));
  std::size_t movable = 0, axes = 0;
  for (const render::Instance& instance : visual->desc.instances) {
    if (!instance.movable) continue;
    const glm::mat4& X = frame.X_WM[movable++];
    if (instance.follows != scenario::kFollowsHoldingPoint) continue;
    ++axes;
    EXPECT_LT((Vec3(X[3].x, X[3].y, X[3].z) - expected).norm(), 1e-6);
    EXPECT_LT((Vec3(X[0].x, X[0].y, X[0].z) - record.X_WT.q * Vec3::UnitX()).norm(), 1e-6);
  }
  EXPECT_EQ(axes, 3U);
}

}  // namespace
}  // namespace fulcrum::test
