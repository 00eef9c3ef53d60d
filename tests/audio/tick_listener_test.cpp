// What is heard of records that are made up here, whose blows are known.

#include "engine/audio/tick_listener.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "tests/haptics/bake/shapes.h"
#include "tests/haptics/scenes.h"

namespace fulcrum::audio {
namespace {

SceneSound scene_at(double rate_Hz) {
  SceneSound scene;
  scene.tick_s = 1 / rate_Hz;
  scene.scene_field = test::floor_field();
  scene.tool_shell = test::shell_of({Vec3(0, 0, -0.05), Vec3(0, 0, 0.05), Vec3(0, 0.02, -0.05)});
  return scene;
}

// A hand that comes down on a floor at y = 0 with its tool, whose tip is 100 mm before it: the tool stays
// above the floor, and is pushed while the hand is below.
class Descent {
public:
  explicit Descent(double tick_s) : tick_s_(tick_s) {}

  TickRecord at(std::int64_t tick, double height, double sideways = 0) {
    TickRecord record;
    record.tick = tick;
    record.X_WH.p = Vec3(sideways, height, 0.1);
    record.X_WT.p = Vec3(sideways, std::max(height, 0.0) + 0.001, 0.05);
    record.X_WT.q = Quat(Eigen::AngleAxisd(-0.02, Vec3::UnitX()));  // the tip is 1 mm below the middle
    record.regions = height <= 0 ? 1 : 0;
    record.contact_F_T_W.force = Vec3(0, height < 0 ? -1000 * height : 0, 0);
    record.V_WT.v = Vec3(sideways_before_ ? (sideways - *sideways_before_) / tick_s_ : 0, 0, 0);
    sideways_before_ = sideways;
    return record;
  }

private:
  double tick_s_;
  std::optional<double> sideways_before_;
};

TEST(TickListener, FindsTheSpeedAndThePlaceOfABlow) {
  for (const double rate_Hz : {100.0, 1000.0, 4000.0, 20000.0}) {
    const SceneSound scene = scene_at(rate_Hz);
    TickListener listener(scene);
    Descent descent(scene.tick_s);
    std::vector<Blow> blows;
    for (std::int64_t tick = 0; tick < std::llround(rate_Hz); ++tick) {
      const Heard heard =
          listener.next(descent.at(tick, 0.0501 - 0.2 * static_cast<double>(tick) * scene.tick_s));
      if (heard.blow) blows.push_back(*heard.blow);
    }
    ASSERT_EQ(blows.size(), 1u) << rate_Hz;
    EXPECT_NEAR(blows[0].speed, 0.2, 1e-3) << rate_Hz;
    EXPECT_LT(blows[0].p_W.norm(), 1e-4) << "at the tip";
    EXPECT_NEAR(blows[0].radius, 0.1, 1e-3);
  }
}

TEST(TickListener, TouchThatTremblesIsOneBlowAndTouchAfterARestAnother) {
  const SceneSound scene = scene_at(1000);
  TickListener listener(scene);
  Descent descent(scene.tick_s);
  int blows = 0;
  std::int64_t tick = 0;
  const auto go = [&](double height) { blows += listener.next(descent.at(tick++, height)).blow.has_value(); };
  for (int i = 0; i < 20; ++i) go(0.0101 - 0.001 * i);  // 1 m/s
  EXPECT_EQ(blows, 1);
  for (int i = 0; i < 500; ++i) go(i % 3 == 0 ? 0.001 : -0.001);
  EXPECT_EQ(blows, 1);
  for (int i = 0; i < 60; ++i) go(0.01);
  for (int i = 0; i < 20; ++i) go(0.0101 - 0.001 * i);
  EXPECT_EQ(blows, 2);
  // Laid down by less than 10 mm/s, it is none.
  for (int i = 0; i < 60; ++i) go(0.0001);
  for (int i = 0; i < 60; ++i) go(0.0001 - 0.000005 * i);
  EXPECT_EQ(blows, 2);
}

TEST(TickListener, WhatTouchesFromTheBeginningOrAfterAStopIsNoBlow) {
  const SceneSound scene = scene_at(1000);
  TickListener listener(scene);
  Descent descent(scene.tick_s);
  std::int64_t tick = 0;
  for (int i = 0; i < 100; ++i) EXPECT_FALSE(listener.next(descent.at(tick++, -0.001 - 0.001 * i)).blow);
  for (int i = 0; i < 100; ++i) EXPECT_FALSE(listener.next(descent.at(tick++, 0.05)).blow);
  for (int i = 0; i < 100; ++i) {
    TickRecord record = descent.at(tick++, 0.05 - 0.001 * i);
    record.stopped = true;
    const Heard heard = listener.next(record);
    EXPECT_FALSE(heard.blow);
    EXPECT_FALSE(heard.slide);
  }
  for (int i = 0; i < 100; ++i) EXPECT_FALSE(listener.next(descent.at(tick++, -0.05 - 0.001 * i)).blow);
}

TEST(TickListener, TakesTheImpactsOfARecordAsTheyAre) {
  TickListener listener(scene_at(1000));
  Descent descent(1e-3);
  TickRecord record = descent.at(0, 0.1);
  record.impact.emplace();
  EXPECT_FALSE(listener.next(record).blow);
  record = descent.at(1, 0.1);
  record.impact.emplace() = {2, {Vec3(0.1, 0.1, 0.1), Vec3::UnitY(), 0.7, 3}};
  const Heard heard = listener.next(record);
  ASSERT_TRUE(heard.blow);
  EXPECT_EQ(heard.blow->speed, 0.7);
  EXPECT_EQ(heard.blow->object, 0);
  EXPECT_EQ(heard.blow->p_W, Vec3(0.1, 0.1, 0.1));
  EXPECT_NEAR(heard.blow->radius, 0.1, 1e-12);
  // A touch without an impact is none, where impacts are detected.
  record = descent.at(100, -0.1);
  record.impact.emplace();
  EXPECT_FALSE(listener.next(record).blow);
}

TEST(TickListener, KnowsWhichObjectWasStruck) {
  const std::vector<Vec3> samples{Vec3(-0.05, 0, 0), Vec3(0.05, 0, 0)};
  const std::vector<std::int32_t> objects{4, 7};
  for (const double side : {-0.04, 0.04}) {
    SceneSound scene = scene_at(1000);
    scene.objects = std::make_shared<ObjectMap>(samples, objects);
    TickListener listener(scene);
    Descent descent(1e-3);
    std::vector<Blow> blows;
    for (std::int64_t tick = 0; tick < 40; ++tick) {
      const Heard heard = listener.next(descent.at(tick, 0.01 - 0.001 * static_cast<double>(tick), side));
      if (heard.blow) blows.push_back(*heard.blow);
    }
    ASSERT_EQ(blows.size(), 1u);
    EXPECT_EQ(blows[0].object, side < 0 ? 4 : 7);
  }
}

// Of a tool of many points, some are looked at: the place is as near as those lie.
TEST(DeepestPointFinder, FindsTheEndThatHangsDownOfALargeTool) {
  std::vector<Vec3> points;
  for (int i = 0; i < 200; ++i)
    for (int k = 0; k < 100; ++k) points.emplace_back(-0.05 + 5e-4 * i, 0.02, -0.025 + 5e-4 * k);
  DeepestPointFinder finder(test::shell_of(points).get(), test::floor_field());
  const Pose tilted{Quat(Eigen::AngleAxisd(-0.1, Vec3::UnitZ())), Vec3(0, -0.01, 0)};
  const std::optional<DeepestPoint> touch = finder.find(tilted);
  ASSERT_TRUE(touch);
  EXPECT_NEAR(touch->p_T.x(), 0.05, 6e-3);  // the end that hangs down
  EXPECT_NEAR(touch->nhat_W.y(), 1, 1e-3);
  EXPECT_FALSE(DeepestPointFinder(nullptr, test::floor_field()).find(tilted));
  EXPECT_FALSE(DeepestPointFinder(test::shell_of(points).get(), nullptr).find(tilted));
}

TEST(DeepestPointFinder, FindsThatEndOnTriangles) {
  const auto features = [](const Vec3& low, const Vec3& high) {
    const Solid box = shapes::solid_of(shapes::box(low, high));
    return std::make_shared<const FeatureMesh>(box.mesh, box.neighbours);
  };
  DeepestPointFinder finder(features(Vec3(-0.05, 0.02, -0.025), Vec3(0.05, 0.03, 0.025)),
                            features(Vec3(-1, -0.1, -1), Vec3(1, 0, 1)));
  // The corner that hangs down, 10 um above the floor.
  const Quat turned(Eigen::AngleAxisd(-0.1, Vec3::UnitZ()));
  const double above = 1e-5;
  const Pose tilted{turned, Vec3(0, above - (turned * Vec3(0.05, 0.02, 0)).y(), 0)};
  const std::optional<DeepestPoint> touch = finder.find(tilted);
  ASSERT_TRUE(touch);
  EXPECT_NEAR((tilted * touch->p_T).y(), above, 1e-9);
  EXPECT_NEAR(touch->p_T.x(), 0.05, 1e-9);
  EXPECT_NEAR(touch->nhat_W.y(), 1, 1e-9);
  EXPECT_FALSE(finder.find({turned, tilted.p + Vec3(0, 1e-3, 0)})) << "nothing is near";
}

TEST(TickListener, HearsSlidingAlongWhatItTouches) {
  TickListener listener(scene_at(1000));
  Descent descent(1e-3);
  listener.next(descent.at(0, 0.1));
  listener.next(descent.at(1, -0.001));
  const Heard heard = listener.next(descent.at(2, -0.002, 0.0003));
  ASSERT_TRUE(heard.slide);
  EXPECT_NEAR(heard.slide->speed, 0.3, 1e-3);
  EXPECT_NEAR(heard.slide->force, 2, 1e-9);
  EXPECT_FALSE(listener.next(descent.at(3, 0.01)).slide);
}

TEST(TickListener, SurvivesLostTicksAndWhatIsNoNumber) {
  TickListener listener(scene_at(1000));
  Descent descent(1e-3);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (std::int64_t tick = 0; tick < 300; tick += 30) {
    TickRecord record = descent.at(tick, 0.1 - 0.0005 * static_cast<double>(tick));
    const Heard heard = listener.next(record);
    if (heard.blow) EXPECT_NEAR(heard.blow->speed, 0.5, 1e-2);
    record.contact_F_T_W.force.x() = nan;
    EXPECT_FALSE(listener.next(record).blow);
    record.contact_F_T_W = {};
    record.X_WH.p.y() = nan;
    EXPECT_FALSE(listener.next(record).blow);
  }
}

}  // namespace
}  // namespace fulcrum::audio
