#include "haptics/tool/rigid_body.h"

#include <Eigen/Cholesky>
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

// 1/m of a direction n is n . (1/m + (p x n)^T I^-1 (p x n)).
double RigidBody::least_mass_at(const Vec3& p_T) const {
  Mat3 turned;  // p x n
  turned << 0, -p_T.z(), p_T.y(), p_T.z(), 0, -p_T.x(), -p_T.y(), p_T.x(), 0;
  const Mat3 about = turned.transpose() * inverse_inertia_T_ * turned;
  return 1 /
         (1 / mass_ + Eigen::SelfAdjointEigenSolver<Mat3>(about, Eigen::EigenvaluesOnly).eigenvalues()[2]);
}

double RigidBody::kinetic_energy(const BodyState& state) const noexcept {
  const Twist& V = state.V_WT;
  return 0.5 * mass_ * V.v.squaredNorm() + 0.5 * V.w.dot(inertia_W(state.X_WT.q) * V.w);
}

Twist RigidBody::accelerate(const BodyState& state, const Wrench& F_T_W, double tick_s) const noexcept {
  const Vec3& w = state.V_WT.w;
  const Vec3 gyroscopic = w.cross(inertia_W(state.X_WT.q) * w);
  Twist after = state.V_WT;
  after.v += tick_s / mass_ * F_T_W.force;
  after.w += tick_s * (inverse_inertia_W(state.X_WT.q) * (F_T_W.torque - gyroscopic));
  return after;
}

Twist RigidBody::accelerate(const BodyState& state, const Wrench& F_T_W, const Linearisation& around,
                            double tick_s) const noexcept {
  const Mat3 I = inertia_W(state.X_WT.q);
  Vec6 V, F;
  V << state.V_WT.v, state.V_WT.w;
  F << F_T_W.force, F_T_W.torque - state.V_WT.w.cross(I * state.V_WT.w);
  Mat6 A = tick_s * around.B + tick_s * tick_s * around.K;
  A.topLeftCorner<3, 3>().diagonal().array() += mass_;
  A.bottomRightCorner<3, 3>() += I;
  V += A.ldlt().solve(tick_s * (F - tick_s * (around.K * V)));
  return {V.head<3>(), V.tail<3>()};
}

RigidBody::Move RigidBody::accelerate_keeping_momentum(const BodyState& state, const Wrench& F_T_W,
                                                       double tick_s) const noexcept {
  const Vec3 momentum = inertia_W(state.X_WT.q) * state.V_WT.w + tick_s * F_T_W.torque;
  const Mat3 inverse_inertia = inverse_inertia_W(state.X_WT.q);
  const Vec3 w = inverse_inertia * momentum;
  Move move;
  move.during.v = state.V_WT.v + tick_s / mass_ * F_T_W.force;
  move.during.w = w - 0.5 * tick_s * (inverse_inertia * w.cross(momentum));
  move.after.v = move.during.v;
  move.after.w = inverse_inertia_W(quaternion_exp(tick_s * move.during.w) * state.X_WT.q) * momentum;
  return move;
}

Pose RigidBody::advance(const Pose& X_WT, const Twist& V_WT, double tick_s) noexcept {
  Pose after;
  after.p = X_WT.p + tick_s * V_WT.v;
  after.q = (quaternion_exp(tick_s * V_WT.w) * X_WT.q).normalized();
  return after;
}

}  // namespace fulcrum
