#include "haptics/tool/rigid_body.h"

#include <Eigen/Eigenvalues>

#include "haptics/math/rotation.h"

namespace fulcrum {

RigidBody::RigidBody(double mass, const Mat3& inertia_T)
    : mass_(mass), inertia_T_(inertia_T), inverse_inertia_T_(inertia_T.inverse()) {
  const Eigen::SelfAdjointEigenSolver<Mat3> principal(inertia_T);
  smallest_inertia_ = principal.eigenvalues()[0];
  root_inertia_T_ = principal.operatorSqrt();
}

Mat3 RigidBody::inertia_W(const Quat& q_WT) const {
  const Mat3 R = q_WT.toRotationMatrix();
  return R * inertia_T_ * R.transpose();
}

Mat3 RigidBody::inverse_inertia_W(const Quat& q_WT) const {
  const Mat3 R = q_WT.toRotationMatrix();
  return R * inverse_inertia_T_ * R.transpose();
}

Mat3 RigidBody::root_inertia_W(const Quat& q_WT) const {
  const Mat3 R = q_WT.toRotationMatrix();
  return R * root_inertia_T_ * R.transpose();
}

Twist RigidBody::accelerate(const BodyState& state, const Wrench& F_T_W, double tick_s) const noexcept {
  const Vec3& w = state.V_WT.w;
  const Vec3 gyroscopic = w.cross(inertia_W(state.X_WT.q) * w);
  Twist after = state.V_WT;
  after.v += tick_s / mass_ * F_T_W.force;
  after.w += tick_s * (inverse_inertia_W(state.X_WT.q) * (F_T_W.torque - gyroscopic));
  return after;
}

Pose RigidBody::advance(const Pose& X_WT, const Twist& V_WT, double tick_s) noexcept {
  Pose after;
  after.p = X_WT.p + tick_s * V_WT.v;
  after.q = (quaternion_exp(tick_s * V_WT.w) * X_WT.q).normalized();
  return after;
}

}  // namespace fulcrum
