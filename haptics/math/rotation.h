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

}  // namespace fulcrum
