#pragma once
// Rigid poses. X_AB is the pose of frame B in frame A: it takes coordinates in B to coordinates in A.

#include "haptics/math/linear.h"

namespace fulcrum {

struct Pose {
  Quat q = Quat::Identity();  // orientation, unit
  Vec3 p = Vec3::Zero();      // (3) m

  Vec3 operator*(const Vec3& p_B) const { return q * p_B + p; }
  Pose operator*(const Pose& X_BC) const { return {q * X_BC.q, q * X_BC.p + p}; }
  Pose inverse() const {
    const Quat q_inverse = q.conjugate();
    return {q_inverse, -(q_inverse * p)};
  }
  bool is_finite() const { return p.allFinite() && q.coeffs().allFinite(); }
};

// Velocity of a body, expressed in W; the linear part is that of the body's origin.
struct Twist {
  Vec3 v = Vec3::Zero();  // (3) m/s
  Vec3 w = Vec3::Zero();  // (3) rad/s
};

}  // namespace fulcrum
