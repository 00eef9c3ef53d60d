// Reference: two first-order lags of 15 ms in a row, by their closed form: of a step, 1 - (1 + t/tau)
// e^(-t/tau) is done after t.

#include "drivers/mouse/mouse_device.h"

#include <gtest/gtest.h>

#include <cmath>

#include "haptics/math/rotation.h"

namespace fulcrum::test {
namespace {

constexpr double kLag = 15e-3;  // s

double step_response(double t) {
  return 1 - (1 + t / kLag) * std::exp(-t / kLag);
}

TEST(MouseDevice, RestsWhereItBeganUntilItIsAimed) {
  const Pose X_DH{quaternion_exp(Vec3(0.1, 0.2, -0.3)), Vec3(0.01, -0.02, 0.03)};
  MouseDevice mouse(MouseDevice::mouse_desc(), X_DH, 1e-3);
  for (int tick = 0; tick < 100; ++tick) {
    const DeviceSample sample = mouse.read();
    EXPECT_LT((sample.X_DH.p - X_DH.p).norm(), 1e-15);
    EXPECT_LT(rotation_vector(sample.X_DH.q * X_DH.q.conjugate()).norm(), 1e-12);
    EXPECT_TRUE(sample.connected);
  }
}

TEST(MouseDevice, FollowsAsTwoLagsInARow) {
  for (const double tick_s : {1e-4, 1e-3}) {
    MouseDevice mouse(MouseDevice::mouse_desc(), Pose{}, tick_s);
    const Vec3 step(0.02, 0, -0.01), turn(0, 0.4, 0);
    mouse.aim({quaternion_exp(turn), step});
    for (int tick = 1; tick * tick_s <= 0.1; ++tick) {
      const Pose X_DH = mouse.read().X_DH;
      // The filters are stepped: their outputs are those of the lags to within a tick of their own speed.
      const double done = step_response(tick * tick_s), off = 1.1 * tick_s / kLag;
      EXPECT_NEAR(X_DH.p.x() / step.x(), done, off) << tick;
      EXPECT_NEAR(X_DH.p.z() / step.z(), done, off) << tick;
      EXPECT_NEAR(rotation_vector(X_DH.q).y() / turn.y(), done, off) << tick;
    }
  }
}

// However often a screen moves it on, its speed has no steps: in a tick it changes by no more than two lags
// allow.
TEST(MouseDevice, AStepOfTheScreenIsNoStepOfTheHandle) {
  MouseDevice mouse(MouseDevice::mouse_desc(), Pose{}, 1e-3);
  const double step = 5e-3, part = 1 - std::exp(-1e-3 / kLag);
  Vec3 p = Vec3::Zero(), v = Vec3::Zero();
  for (int tick = 0; tick < 600; ++tick) {
    if (tick % 16 == 0) mouse.aim({Quat::Identity(), Vec3(step * (tick / 16), 0, 0)});
    const Vec3 next = mouse.read().X_DH.p;
    EXPECT_LE((next - p - v).norm(), 2 * part * part * step * 1.5) << tick;
    v = next - p;
    p = next;
  }
}

TEST(MouseDevice, CannotPush) {
  const DeviceDesc desc = MouseDevice::mouse_desc();
  EXPECT_FALSE(desc.renders_force);
  EXPECT_EQ(desc.max_force, 0);
  EXPECT_EQ(desc.name, "mouse");
}

}  // namespace
}  // namespace fulcrum::test
