// Mirror images against the matrices that they stand for: M p and M X M, with M = diag(-1, 1, 1).

#include "haptics/math/mirror.h"

#include <gtest/gtest.h>

#include <cmath>

#include "haptics/math/rotation.h"

namespace fulcrum {
namespace {

const Mat3 M = Vec3(-1, 1, 1).asDiagonal();

TEST(Mirror, OfAPoseIsThatOfItsMatrix) {
  for (const Vec3& turn : {Vec3(0.3, -1.1, 2.0), Vec3(3.0, 0.2, 0), Vec3(0, 0, 0), Vec3(0, 0, 1.5)}) {
    const Pose X{quaternion_exp(turn), {0.4, -0.2, 0.1}};
    Pose mirrored = X;
    mirror(mirrored);
    const Mat3 difference = mirrored.q.toRotationMatrix() - M * X.q.toRotationMatrix() * M;
    EXPECT_LT(difference.norm(), 1e-15);
    EXPECT_EQ(mirrored.p, M * X.p);
    // A point that the pose carries is carried to its own image.
    const Vec3 p(0.01, 0.02, -0.03);
    EXPECT_LT((mirrored * Vec3(M * p) - M * (X * p)).norm(), 1e-15);
    mirror(mirrored);
    EXPECT_EQ(mirrored.q.coeffs(), X.q.coeffs());
    EXPECT_EQ(mirrored.p, X.p);
  }
}

// The axis to the right of a finger that points somewhere, with its nail somewhere: finger x nail.
TEST(Mirror, AnAxisToTheRightStaysToTheRight) {
  const Vec3 finger(0.2, -0.3, -0.9), nail(0.1, 0.8, -0.2);
  Vec3 right = finger.cross(nail);
  mirror_axis(right);
  EXPECT_LT((right - (M * finger).cross(M * nail)).norm(), 1e-15);
}

TEST(Mirror, ZeroKeepsItsSign) {
  Vec3 p(0, 1, 2);
  mirror(p);
  EXPECT_FALSE(std::signbit(p.x()));
}

}  // namespace
}  // namespace fulcrum
