#pragma once
// Rotation vectors: axis times angle, the exponential coordinates of SO(3).

#include "haptics/math/linear.h"

namespace fulcrum {

// The shortest rotation vector of q, (3) rad, |result| <= pi. At exactly pi both signs of the axis describe
// the rotation; the one whose first non-zero component is positive is returned, so that the answer is a
// function.
Vec3 rotation_vector(const Quat& q);

// The unit quaternion of a rotation vector (3) rad; exact down to zero length.
Quat quaternion_exp(const Vec3& rotation);

// The rotation vector of q that lies nearest to `previous`: where the shortest one flips its axis at pi, this
// one goes on, up to |result| <= 2 pi. Keeps a torque from reversing when the hand winds past half a turn.
Vec3 rotation_vector_near(const Quat& q, const Vec3& previous);

// The following do what Eigen's AngleAxis, slerp and angularDistance do, which call the C library.

// By an angle (rad) about a unit axis.
Quat turn_by(double angle, const Vec3& axis);

// rad, 0 to pi.
double angle_of(const Quat& q);
double angle_between(const Quat& a, const Quat& b);
// Exact where they are nearly parallel, too; neither need be of length 1.
double angle_between(const Vec3& u, const Vec3& v);

// From 0 at `from` to 1 at `to`, the shorter way, at a steady pace. K. Shoemake, "Animating rotation with
// quaternion curves", SIGGRAPH 1985.
Quat slerp(const Quat& from, const Quat& to, double part);

}  // namespace fulcrum
