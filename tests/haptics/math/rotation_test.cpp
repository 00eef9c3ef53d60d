#include "haptics/math/rotation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "haptics/math/split_mix.h"

namespace fulcrum {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(Rotation, ExponentialAndLogarithmAreInverse) {
  for (double angle : {0.0, 1e-12, 1e-6, 0.3, 1.0, 3.0, kPi - 1e-9}) {
    const Vec3 rotation = angle * Vec3(1, -2, 0.5).normalized();
    EXPECT_NEAR((rotation_vector(quaternion_exp(rotation)) - rotation).norm(), 0, 1e-12 + 1e-9 * angle)
        << angle;
  }
}

TEST(Rotation, BothSignsOfAQuaternionAreOneRotation) {
  const Quat q = quaternion_exp(Vec3(0.3, 0.2, -1.0));
  const Quat minus(-q.w(), -q.x(), -q.y(), -q.z());
  EXPECT_NEAR((rotation_vector(q) - rotation_vector(minus)).norm(), 0, 1e-15);
}

TEST(Rotation, HalfATurnHasOneAnswer) {
  EXPECT_EQ(rotation_vector(Quat(0, 0, -1, 0)), rotation_vector(Quat(0, 0, 1, 0)));
  EXPECT_NEAR((rotation_vector(Quat(0, 0, 1, 0)) - Vec3(0, kPi, 0)).norm(), 0, 1e-15);
}

// A hand that winds on past half a turn is pulled back the way it came, not the short way round.
TEST(Rotation, WindingPastHalfATurnGoesOn) {
  Vec3 rotation = Vec3::Zero();
  for (double angle = 0; angle < 1.9 * kPi; angle += 0.01)
    rotation = rotation_vector_near(quaternion_exp(Vec3(0, angle, 0)), rotation);
  EXPECT_NEAR(rotation.y(), 1.9 * kPi, 0.011);
}

// Eigen's own, which call the C library, are the truth to rounding.
TEST(Rotation, TurnsAnglesAndWaysBetweenAreEigens) {
  SplitMix random(3);
  const auto any = [&] {
    return Quat(random.normal(), random.normal(), random.normal(), random.normal()).normalized();
  };
  for (int i = 0; i < 1000; ++i) {
    const Vec3 axis = Vec3(random.normal(), random.normal(), random.normal()).normalized();
    const double angle = 8 * random.uniform() - 4;
    EXPECT_NEAR((turn_by(angle, axis).coeffs() - Quat(Eigen::AngleAxisd(angle, axis)).coeffs()).norm(), 0,
                1e-15);
    const Quat a = any(), b = any();
    EXPECT_NEAR(angle_of(a), Eigen::AngleAxisd(a).angle(), 1e-14);
    EXPECT_NEAR(angle_between(a, b), a.angularDistance(b), 1e-14);
    for (const double part : {0.0, 0.3, 1.0})
      EXPECT_NEAR((slerp(a, b, part).coeffs() - a.slerp(part, b).coeffs()).norm(), 0, 1e-14);
    EXPECT_NEAR((slerp(a, a, 0.5).coeffs() - a.coeffs()).norm(), 0, 1e-15);
  }
}

}  // namespace
}  // namespace fulcrum
