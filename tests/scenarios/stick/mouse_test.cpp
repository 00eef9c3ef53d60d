// A hand that no motor holds back does not take the stick through the ball.

#include <gtest/gtest.h>

#include <algorithm>

#include "drivers/mouse/mouse_device.h"
#include "engine/app/picture/bridge.h"
#include "engine/app/prepare/inventory.h"
#include "haptics/loop/run_tick.h"

namespace fulcrum::test {
namespace {

struct Push {
  double deepest = 0;  // m
  double most = 0;     // N, of the coupling
  ui::Dial gauge;      // at the end
  double gauge_most = 0;
};

// The mouse goes down by `way` m from where the stick starts, 32 mm above the ball, and stays.
Push push_down(const app::Prepared& stick, const SceneDesc& scene, double way) {
  Result<World> world = World::build(scene);
  EXPECT_TRUE(world) << world.error().sentence;
  Push push;
  if (!world) return push;
  Pose X_WH = scene.tool.X_WT_start * scene.tool.X_HT.inverse();
  MouseDevice mouse(MouseDevice::mouse_desc(), X_WH, scene.tick_s);
  X_WH.p.y() -= way;
  mouse.aim(X_WH);
  for (int tick = 0; tick < 1000; ++tick) {
    TickEvent event;
    run_tick(*world, mouse, {}, event);
    const TickRecord& record = event.record;
    push.deepest = std::max(push.deepest, record.depth_max);
    push.most = std::max(push.most, record.coupling_F_T_W.force.norm());
    const scenario::TaskState none = state_after(stick.haptic.task, {});
    push.gauge = app::overlay_state(stick, world->desc(), record, {}, none).force_N;
    push.gauge_most = std::max(push.gauge_most, push.gauge.value);
  }
  return push;
}

TEST(Mouse, DoesNotTakeTheStickThroughTheBall) {
  const std::optional<app::Prepared> stick = app::prepare("stick", std::vector<std::string>());
  ASSERT_TRUE(stick);
  const SceneDesc scene = app::scene_for_device(*stick, "mouse");
  for (const double way : {0.034, 0.05, 0.08}) {
    const Push push = push_down(*stick, scene, way);
    EXPECT_LT(push.deepest, 50e-6) << way;
    EXPECT_GT(push.most, 0.3) << way;
    EXPECT_LE(push.gauge_most, push.gauge.limit) << way;
  }
}

// N: what the device of the scenario would be asked for, its handle `way` m below where it starts.
double pushed_directly(const SceneDesc& scene, double way) {
  Result<World> world = World::build(scene);
  EXPECT_TRUE(world) << world.error().sentence;
  if (!world) return 0;
  Pose X_WH = scene.tool.X_WT_start * scene.tool.X_HT.inverse();
  X_WH.p.y() -= way;
  DeviceSample sample;
  sample.X_DH = scene.mapping.handle_in_device(X_WH);
  return step(*world, sample, {}).record.coupling_F_T_W.force.norm();
}

TEST(Mouse, ShowsTheForceOfALightPushAsADeviceWouldGiveIt) {
  const std::optional<app::Prepared> stick = app::prepare("stick", std::vector<std::string>());
  ASSERT_TRUE(stick);
  const SceneDesc scene = app::scene_for_device(*stick, "mouse");
  ASSERT_EQ(stick->haptic.scene.contact.response, ContactResponse::direct);
  for (const double way : {0.0283, 0.0286}) {
    const double direct = pushed_directly(stick->haptic.scene, way);
    EXPECT_GT(direct, 0.03) << way;
    EXPECT_NEAR(push_down(*stick, scene, way).gauge.value, direct, 0.1 * direct) << way;
  }
}

TEST(Mouse, GetsAConstraintThatExplainNames) {
  const std::optional<app::Prepared> stick = app::prepare("stick", std::vector<std::string>());
  ASSERT_TRUE(stick);
  const Result<World> world = World::build(app::scene_for_device(*stick, "mouse"));
  ASSERT_TRUE(world) << world.error().sentence;
  const app::Inventory list = app::inventory(*world, *stick, nullptr);
  EXPECT_TRUE(std::ranges::any_of(
      list.built, [](const auto& item) { return item.name == "coupling"; }));
  const auto direct =
      std::ranges::find_if(list.left_out, [](const auto& item) { return item.name == "response direct"; });
  ASSERT_NE(direct, list.left_out.end());
  EXPECT_NE(direct->note.find("'mouse' cannot push"), std::string::npos) << direct->note;
}

// One that vibrates and does not push is one without motors; a scene that names it has the constraint, too.
TEST(Mouse, IsNotTheOnlyDeviceWithoutMotors) {
  const std::optional<app::Prepared> stick =
      app::prepare("stick", std::vector<std::string>{"device.model=two_channel"});
  ASSERT_TRUE(stick);
  EXPECT_EQ(stick->haptic.scene.contact.response, ContactResponse::constraint);
  SceneDesc direct = stick->haptic.scene;
  direct.contact.response = ContactResponse::direct;
  const Result<World> refused = World::build(direct);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().sentence.find("name another response"), std::string::npos);
}

}  // namespace
}  // namespace fulcrum::test
