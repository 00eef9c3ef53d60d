#pragma once
// Force and moment on a body, expressed in W. F_T_W: the wrench on T about T's origin.

#include "haptics/math/linear.h"

namespace fulcrum {

struct Wrench {
  Vec3 force = Vec3::Zero();   // (3) N
  Vec3 torque = Vec3::Zero();  // (3) N m

  Wrench operator+(const Wrench& other) const { return {force + other.force, torque + other.torque}; }
  Wrench& operator+=(const Wrench& other) { return *this = *this + other; }
  Wrench operator-() const { return {-force, -torque}; }
  Wrench operator*(double s) const { return {force * s, torque * s}; }
  bool is_zero() const { return force.isZero(0) && torque.isZero(0); }
  bool is_finite() const { return force.allFinite() && torque.allFinite(); }

  // The same wrench about another point. p_AB: from the old reference point to the new one, in W.
  Wrench moved_by(const Vec3& p_AB) const { return {force, torque - p_AB.cross(force)}; }
};

}  // namespace fulcrum
