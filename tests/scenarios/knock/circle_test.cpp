// The circle of confusion: what lies on it, how it moves with the tool, and when it is gone.

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "engine/app/picture/afterglow.h"

namespace fulcrum::test {
namespace {

Vec3 widened(const glm::vec4& v) {
  return {v.x, v.y, v.z};
}

const Vec3 kHeld_T(0.02, -0.03, 0.05);  // p_TH

// A blow at p_W on a tool that is held at p_WH, with the cues of it.
TickRecord struck(const Vec3& p_W, const Vec3& nhat_W) {
  TickRecord record;
  record.X_WT = {Quat(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized())), Vec3(0.1, 0.2, -0.1)};
  record.X_WH = {record.X_WT.q, record.X_WT * kHeld_T};
  record.impact = ImpactTick{.count = 1, .hardest = {.p_W = p_W, .nhat_W = nhat_W, .speed = 0.1}};
  const Vec3 r_W = p_W - record.X_WH.p;
  record.impact_vibration = ImpactVibrationRecord{};
  record.impact_vibration->gain = 1;
  record.impact_vibration->frequency_Hz = 20;
  record.impact_vibration->radius = r_W.norm();
  record.impact_vibration->axis_W = r_W.cross(nhat_W).normalized();
  return record;
}

std::vector<glm::mat4> poses(const app::Afterglow& afterglow, const Pose& X_WT, double time) {
  render::VisualDesc desc;
  app::add_impact_circle(desc);
  std::vector<glm::mat4> X_WM;
  for (const render::Instance& instance : desc.instances)
    X_WM.push_back(app::impact_circle_pose(instance.follows, afterglow.struck(), X_WT, time));
  return X_WM;
}

// The dot is the last of them.
TEST(Circle, IsOfWhatTurnsTheHandAboutTheSameAxis) {
  const Vec3 p_W(0.2, 0.1, 0.04), nhat_W = Vec3(-0.2, 0.9, 0.3).normalized();
  const TickRecord record = struck(p_W, nhat_W);
  app::Afterglow afterglow(kHeld_T);
  afterglow.add(record, 1.0);
  ASSERT_TRUE(afterglow.struck());
  const std::vector<glm::mat4> X_WM = poses(afterglow, record.X_WT, 1.1);
  const Vec3 axis_W = (p_W - record.X_WH.p).cross(nhat_W).normalized();
  double nearest = 1;
  for (std::size_t i = 0; i + 1 < X_WM.size(); ++i) {
    const Vec3 from = widened(X_WM[i][3]) - record.X_WH.p;
    EXPECT_NEAR(from.norm(), (p_W - record.X_WH.p).norm(), 1e-6);
    EXPECT_NEAR(from.dot(axis_W), 0, 1e-6);
    // Each piece ends where the next one begins.
    const Vec3 to = widened(X_WM[i] * glm::vec4(0, 0, 1, 1));
    EXPECT_LT((to - widened(X_WM[(i + 1) % (X_WM.size() - 1)][3])).norm(), 1e-6);
    EXPECT_GT(glm::determinant(glm::mat3(X_WM[i])), 0.0F);
    nearest = std::min(nearest, (from + record.X_WH.p - p_W).norm());
  }
  EXPECT_LT(nearest, 0.5 * widened(X_WM[0][2]).norm() + 1e-6);
  EXPECT_LT((widened(X_WM.back()[3]) - p_W).norm(), 1e-6);
}

TEST(Circle, GoesWithTheToolAndIsGoneAfterAWhile) {
  const Vec3 p_W(0.2, 0.1, 0.04);
  const TickRecord record = struck(p_W, Vec3::UnitY());
  app::Afterglow afterglow(kHeld_T);
  afterglow.add(record, 1.0);
  const Pose X{Quat(Eigen::AngleAxisd(-1.1, Vec3::UnitX())), Vec3(0.3, 0, 0.1)};
  const std::vector<glm::mat4> before = poses(afterglow, record.X_WT, 2),
                               after = poses(afterglow, X * record.X_WT, 2);
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_LT((widened(after[i][3]) - X * widened(before[i][3])).norm(), 1e-6);
  for (const glm::mat4& gone : poses(afterglow, record.X_WT, 1.0 + app::kSeen + 1))
    EXPECT_LT(widened(gone[0]).norm() + widened(gone[1]).norm() + widened(gone[2]).norm(), 1e-5);
}

TEST(Circle, NeedsAnImpactThatIsFelt) {
  app::Afterglow afterglow(kHeld_T);
  TickRecord record = struck({0.2, 0.1, 0}, Vec3::UnitY());
  record.impact_vibration->gain = 0;
  afterglow.add(record, 1.0);
  EXPECT_FALSE(afterglow.struck());
  record.impact_vibration->gain = 1;
  record.impact->count = 0;
  afterglow.add(record, 1.1);
  EXPECT_FALSE(afterglow.struck());
}

// A pulse of one tick is still marked a second later, on its side alone, and not for ever.
TEST(Afterglow, KeepsWhatLastedForOneTick) {
  app::Afterglow afterglow(kHeld_T);
  for (int tick = 0; tick < 6000; ++tick) {
    TickRecord record;
    record.actuator_load[2] = tick == 100 ? -0.8 : 0.1;
    const Knob knobs[] = {{.kind = Command::Kind::pulse_gain,
                           .name = "Pulse",
                           .key = 'B',
                           .level = tick == 100 ? 0.4 : 0.0,
                           .brief = true},
                          {.kind = Command::Kind::ghost_gain, .name = "Ghost", .key = 'G', .level = 0.3}};
    afterglow.add(record, 1e-3 * tick, knobs);
    if (tick == 1100) {
      EXPECT_EQ(afterglow.motors()[2].low, -0.8);
      EXPECT_EQ(afterglow.motors()[2].high, 0.1);
      EXPECT_EQ(afterglow.peak(Command::Kind::pulse_gain), 0.4);
      EXPECT_EQ(afterglow.peak(Command::Kind::ghost_gain), 0);  // it is not brief
      EXPECT_EQ(afterglow.motors()[1].low, 0);
    }
  }
  EXPECT_NEAR(afterglow.motors()[2].low, 0, 1e-3);
}

}  // namespace
}  // namespace fulcrum::test
