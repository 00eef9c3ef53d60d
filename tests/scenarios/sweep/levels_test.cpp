// The target's way, and the bars beside the finger.

#include <gtest/gtest.h>

#include "engine/app/picture/bridge.h"
#include "engine/app/prepare/prepare.h"
#include "engine/app/prepare/tape_header.h"
#include "engine/scenario/followed.h"

namespace fulcrum::test {
namespace {

TEST(Guide, RestsAndGoesAtItsSpeed) {
  const scenario::GuideDesc guide{.from_W = {-0.1, 0, 0.2},
                                  .to_W = {0.1, 0, 0.2},
                                  .speed = 0.375,
                                  .wait = 0.5,
                                  .rest = 0.25};  // a way takes 1 s
  const auto x = [&](double time) { return scenario::guide_place(guide, time).x(); };
  EXPECT_EQ(x(0), -0.1);
  EXPECT_EQ(x(0.5), -0.1);
  EXPECT_NEAR(x(1.0), 0, 1e-12);
  EXPECT_NEAR((x(1.0005) - x(0.9995)) / 1e-3, 0.375, 1e-6) << "the largest speed, in the middle";
  EXPECT_NEAR((x(0.501) - x(0.5)) / 1e-3, 0, 1e-5) << "it sets out slowly";
  EXPECT_NEAR(x(1.5), 0.1, 1e-12);
  EXPECT_NEAR(x(1.75), 0.1, 1e-12);
  EXPECT_NEAR(x(2.25), 0, 1e-12);
  EXPECT_NEAR(x(2.75), -0.1, 1e-12);
  EXPECT_NEAR(x(251.0), 0, 1e-9);  // a hundred rounds later
  EXPECT_NEAR(scenario::guide_place(guide, 2.25).z(), 0.2, 1e-12);
}

// From one end to the other and back, in the window and beyond it: by no more than the tremor would shake a
// hand.
TEST(Guide, TheExpertsHandGoesWithItAllTheWay) {
  const auto sweep = app::prepare("sweep", std::vector<std::string>{});
  ASSERT_TRUE(sweep);
  for (const scenario::HandScript& hand : sweep->haptic.hands) {
    if (hand.name != "expert") continue;
    const HandPath path(hand.waypoints);
    const Vec3 tip_T = sweep->haptic.scene.tool.X_HT.inverse().p;  // H is the lowest point of the pad
    for (double time = 0.68; time < 0.68 + 6 * 1.6 - 0.4; time += 0.01) {
      const Pose X_WT = path.at(time);
      EXPECT_NEAR((X_WT * tip_T).x(), scenario::guide_place(*sweep->scenario.guide, time).x(), 2e-4) << time;
    }
  }
}

// Of each bar as it is posed: its foot, and how high it is.
struct Bar {
  glm::vec3 foot;
  float height = 0;
};

Bar bar_of(const app::Prepared& sweep, const TickRecord& record, std::size_t follows) {
  const auto visual = scenario::assemble_visual(sweep.scenario, sweep.models, sweep.haptic.scene);
  app::FrameBridge bridge(visual->desc, sweep.scenario, sweep.haptic.scene);
  const render::FrameState frame = bridge.frame(record, {}, {}, {}, 0);
  std::size_t movable = 0;
  for (const render::Instance& instance : visual->desc.instances) {
    if (!instance.movable) continue;
    const glm::mat4& X = frame.X_WM[movable++];
    if (instance.follows == follows) return {glm::vec3(X[3]), X[1].y};
  }
  ADD_FAILURE() << "there is no bar that follows " << follows;
  return {};
}

TEST(Levels, AreTheHeightsOfTheBarsAtTheirSides) {
  const std::optional<app::Prepared> sweep = app::prepare("sweep", std::vector<std::string>());
  ASSERT_TRUE(sweep);
  const SceneDesc& scene = sweep->haptic.scene;
  TickRecord record;
  record.X_WH = {Quat::Identity(), Vec3(0.02, 0, 0)};
  record.X_WT = record.X_WH * scene.tool.X_HT;
  const auto heights = [&](double left, double right) {
    VibrotactileRecord& cues = record.vibrotactile_motion.emplace();
    cues.command.level[*scene.device.vibrotactile->find("left")] = left * scene.vibrotactile_motion->strength;
    cues.command.level[*scene.device.vibrotactile->find("right")] =
        right * scene.vibrotactile_motion->strength;
    return std::pair(bar_of(*sweep, record, scenario::kFollowsLeftLevel),
                     bar_of(*sweep, record, scenario::kFollowsRightLevel));
  };
  const auto [whole, none] = heights(1, 0);
  EXPECT_GT(whole.height, 0.02F);
  EXPECT_LT(none.height, 1e-4F);
  EXPECT_GT(none.height, 0.0F);
  EXPECT_LT(whole.foot.x, 0.02F);
  EXPECT_GT(none.foot.x, 0.02F);
  const auto [quarter, half] = heights(0.25, 0.5);
  EXPECT_NEAR(quarter.height, 0.25F * whole.height, 1e-6F);
  EXPECT_NEAR(half.height, 0.5F * whole.height, 1e-6F);
}

// Left is left of the finger as it sweeps, whichever way that is.
TEST(Levels, StandAsTheAxisOfTheSweepDoes) {
  const std::vector<std::pair<const char*, glm::vec3>> axes{
      {"[-1, 0, 0]", {-1, 0, 0}}, {"[0, 0, -1]", {0, 0, -1}}, {"[0.3, 0.9, 0]", {1, 0, 0}}};
  for (const auto& [axis, right] : axes) {
    const std::optional<app::Prepared> sweep =
        app::prepare("sweep", std::vector{std::string("vibrotactile_motion.axis=") + axis});
    ASSERT_TRUE(sweep);
    TickRecord record;
    record.vibrotactile_motion.emplace();
    record.X_WH = {Quat::Identity(), Vec3(0.02, 0, 0.01)};
    record.X_WT = record.X_WH * sweep->haptic.scene.tool.X_HT;
    const glm::vec3 across = bar_of(*sweep, record, scenario::kFollowsRightLevel).foot -
                             bar_of(*sweep, record, scenario::kFollowsLeftLevel).foot;
    EXPECT_NEAR(glm::length(across - 0.048F * right), 0, 1e-6F) << axis;
  }
}

// A mouse has no vibrators: the levels of a sweep are drawn and written all the same, those of a fallback
// not.
TEST(Levels, AreThereWithTheMouseWhereAFingerSweeps) {
  const std::optional<app::Prepared> sweep = app::prepare("sweep", std::vector<std::string>());
  ASSERT_TRUE(sweep);
  const SceneDesc scene = app::scene_for_device(*sweep, "mouse");
  EXPECT_TRUE(scenario::draws_levels(scene));
  EXPECT_TRUE(app::channel_recording(scene));
  EXPECT_FALSE(scene.device.renders_force);
  const std::optional<app::Prepared> fallback = app::prepare(
      "sweep", std::vector<std::string>{"vibrotactile_motion.as=fallback", "device.model=two_channel"});
  ASSERT_TRUE(fallback);
  EXPECT_TRUE(app::channel_recording(fallback->haptic.scene));
  EXPECT_FALSE(app::channel_recording(app::scene_for_device(*fallback, "mouse")));
}

}  // namespace
}  // namespace fulcrum::test
