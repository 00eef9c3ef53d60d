#include "drivers/follow/pose_follower.h"

#include "haptics/math/functions.h"
#include "haptics/math/rotation.h"

namespace fulcrum {
namespace {

Pose toward(const Pose& from, const Pose& to, double part) {
  const Vec3 turn = rotation_vector(to.q * from.q.conjugate());
  return {(quaternion_exp(part * turn) * from.q).normalized(), from.p + part * (to.p - from.p)};
}

}  // namespace

PoseFollower::PoseFollower(const Pose& X_DH, double lag, double tick_s)
    : part_(-math::expm1(-tick_s / lag)), halfway_(X_DH), X_DH_(X_DH) {}

const Pose& PoseFollower::follow(const Pose& wanted_X_DH) noexcept {
  halfway_ = toward(halfway_, wanted_X_DH, part_);
  X_DH_ = toward(X_DH_, halfway_, part_);
  return X_DH_;
}

}  // namespace fulcrum
