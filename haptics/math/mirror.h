#pragma once
// Mirror images through the plane x = 0, M = diag(-1, 1, 1): a place p becomes M p, and a pose X becomes M X
// M, which is a pose again. Mirrored twice, each is what it was, bit for bit.

#include "haptics/math/pose.h"

namespace fulcrum {

template <class Number>
void negate(Number& x) {
  if (x != 0) x = -x;  // 0 stays 0, and does not become -0
}

inline void mirror(Vec3& p) {
  negate(p.x());
}

inline void mirror(Pose& X) {
  mirror(X.p);
  negate(X.q.y());
  negate(X.q.z());
}

// What turns as a rotation's axis does: an axis that is to the right of something, say.
inline void mirror_axis(Vec3& axis) {
  negate(axis.y());
  negate(axis.z());
}

}  // namespace fulcrum
