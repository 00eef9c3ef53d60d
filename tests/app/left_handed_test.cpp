// A scene for the left hand against the scene as it was made: the same hand, mirrored and without its tremor,
// which has no mirror image, moves the tool along the mirror image of its way and feels the mirror image of
// its force, to the rounding of a place in its cell of the distance field.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "engine/app/prepare/prepare.h"
#include "engine/app/run/button_commands.h"
#include "engine/scenario/task_judge.h"
#include "haptics/loop/run_tick.h"
#include "haptics/math/rotation.h"

namespace fulcrum::test {
namespace {

const Mat3 M = Vec3(-1, 1, 1).asDiagonal();

struct Run {
  std::vector<Pose> X_WT;
  Vec3 impulse_D = Vec3::Zero();  // (3) N s, of the device on the hand
  double effort = 0;              // N s, of its size
};

Run run(const std::string& name, bool left) {
  Run result;
  const std::string hand = "hands.expert.";
  std::optional<app::Prepared> prepared =
      app::prepare(name, std::vector<std::string>{hand + "tremor=0", hand + "tremor_rad=0",
                                                  std::string("left_handed=") + (left ? "true" : "false")});
  if (!prepared) {
    ADD_FAILURE() << name;
    return result;
  }
  const SceneDesc& scene = prepared->haptic.scene;
  Result<World> world = World::build(scene);
  auto device = app::simulated_device(*prepared, "expert");
  if (!world || !device) {
    ADD_FAILURE() << name;
    return result;
  }
  scenario::TaskJudge judge(prepared->haptic.task, scene.tick_s);
  TickEvent event;
  app::ButtonCommands buttons(kHandStopButton, kHandGoButton);
  std::vector<Command> commands;
  const auto ticks = static_cast<std::int64_t>(prepared->scenario.time_limit / scene.tick_s);
  for (std::int64_t tick = 0; tick < ticks && !judge.state().completed; ++tick) {
    run_tick(*world, **device, commands, event);
    judge.judge(event.record);
    commands.clear();
    if (const auto pressed = buttons.pressed(event.sample.buttons)) commands.push_back(*pressed);
    result.X_WT.push_back(event.record.X_WT);
    const Vec3& force_D = event.record.device_F_H_D.force;
    result.impulse_D += force_D * scene.tick_s;
    result.effort += force_D.norm() * scene.tick_s;
  }
  EXPECT_TRUE(judge.state().completed) << name << (left ? ", left" : ", right");
  return result;
}

void expect_mirrored(const std::string& name) {
  const Run right = run(name, false), left = run(name, true);
  const std::size_t ticks = std::min(right.X_WT.size(), left.X_WT.size());
  double farthest = 0, turned = 0;
  for (std::size_t i = 0; i < ticks; ++i) {
    farthest = std::max(farthest, (left.X_WT[i].p - M * right.X_WT[i].p).norm());
    Quat q = right.X_WT[i].q;
    q.y() = -q.y();
    q.z() = -q.z();
    turned = std::max(turned, angle_between(left.X_WT[i].q, q));
  }
  const double impulse = (left.impulse_D - M * right.impulse_D).norm() / right.effort;
  std::printf("%s: %zu and %zu ticks, %.3g mm and %.3g rad from its mirror image, impulse %.3g of %.3g N s\n",
              name.c_str(), right.X_WT.size(), left.X_WT.size(), farthest * 1e3, turned, impulse,
              right.effort);
  EXPECT_EQ(left.X_WT.size(), right.X_WT.size());
  EXPECT_LT(farthest, 1e-8);
  EXPECT_LT(turned, 1e-7);  // rad: a tool of 100 mm
  EXPECT_LT(impulse, 1e-5);
}

TEST(LeftHanded, SweepIsTheMirrorImage) {
  expect_mirrored("sweep");
}

TEST(LeftHanded, EverySceneIsTheMirrorImageLong) {
  for (const char* const name : {"piping", "teeth", "ear", "tutorial", "knock"}) expect_mirrored(name);
}

}  // namespace
}  // namespace fulcrum::test
