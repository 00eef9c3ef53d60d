#include "haptics/actuation/joint_chain.h"

#include <algorithm>

#include "haptics/math/rotation.h"

namespace fulcrum {
namespace {

constexpr double kReached = 1e-12;     // m
constexpr double kOutOfReach = 1e-6;   // m
constexpr double kMinDamping = 1e-12;  // of the trace; so little that the last steps are Newton's
constexpr double kRelax = 1e-3, kStiffen = 1e3;
constexpr int kMaxJointSteps = 12;

}  // namespace

JointChain::JointChain(const ArmDesc& arm, const Pose& X_DK)
    : joints_(static_cast<int>(arm.joints.size())), end_D_(X_DK * arm.end_K) {
  for (std::size_t j = 0; j < arm.joints.size(); ++j) {
    const JointDesc& joint = arm.joints[j];
    axis_D_[j] = X_DK.q * joint.axis_K.normalized();
    point_D_[j] = X_DK * joint.point_K;
    home_[j] = joint.home;
    low_[j] = joint.low;
    high_[j] = joint.high;
    parallelogram_[j] = joint.through_parallelogram;
  }
}

JointChain::Placed JointChain::place(const JointAngles& angles) const noexcept {
  Placed placed;
  Pose moved;  // what the joints so far do to a point that they carry
  for (std::size_t j = 0; j < static_cast<std::size_t>(joints_); ++j) {
    placed.axis_D[j] = moved.q * axis_D_[j];
    placed.point_D[j] = moved * point_D_[j];
    const Quat turn = turn_by(angles[j], axis_D_[j]);
    moved = moved * Pose{turn, point_D_[j] - turn * point_D_[j]};
  }
  placed.X_DE = {moved.q.normalized(), moved * end_D_};
  return placed;
}

JointChain::Jacobian JointChain::jacobian(const Placed& placed) const noexcept {
  Jacobian J(joints_, joints_);
  for (int j = 0; j < joints_; ++j) {
    const auto slot = static_cast<std::size_t>(j);
    const Vec3 lever = placed.X_DE.p - placed.point_D[slot];
    J.col(j).head<3>() = placed.axis_D[slot].cross(lever);
    if (joints_ == kMaxJoints) J.col(j).tail<3>() = placed.axis_D[slot];
  }
  return J;
}

JointChain::Offset JointChain::offset(const Pose& X_DE, const Placed& placed) const noexcept {
  Offset offset(joints_);
  offset.head<3>() = X_DE.p - placed.X_DE.p;
  if (joints_ == kMaxJoints) offset.tail<3>() = kLever * rotation_vector(X_DE.q * placed.X_DE.q.conjugate());
  return offset;
}

// Levenberg-Marquardt steps within the stops: a joint at one of them that would go on is left where it is.
double JointChain::descend(const Pose& X_DE, Posture& arm, int steps) const noexcept {
  auto& [angles, placed] = arm;
  double damping = kMinDamping;
  Offset away = offset(X_DE, placed);
  for (int step = 0; step < steps && !(away.norm() < kReached); ++step) {
    Jacobian J = jacobian(placed);
    if (joints_ == kMaxJoints) J.bottomRows<3>() *= kLever;
    const Offset downhill = J.transpose() * away;
    for (int j = 0; j < joints_; ++j) {
      const auto slot = static_cast<std::size_t>(j);
      const bool stuck = downhill[j] > 0 ? angles[slot] >= high_[slot] : angles[slot] <= low_[slot];
      if (stuck) J.col(j).setZero();
    }
    Jacobian normal = J.transpose() * J;
    normal.diagonal().array() += damping * normal.trace() + 1e-300;
    const Offset turn = normal.ldlt().solve(J.transpose() * away);
    JointAngles there = angles;
    for (int j = 0; j < joints_; ++j) {
      const auto slot = static_cast<std::size_t>(j);
      there[slot] = std::clamp(angles[slot] + turn[j], low_[slot], high_[slot]);
    }
    const Placed placed_there = place(there);
    const Offset away_there = offset(X_DE, placed_there);
    if (away_there.squaredNorm() < away.squaredNorm()) {
      angles = there;
      placed = placed_there;
      away = away_there;
      damping = std::max(kMinDamping, damping * kRelax);
    } else {
      damping *= kStiffen;
    }
  }
  return away.norm();
}

double JointChain::reach(const Pose& X_DE, Posture& arm) const noexcept {
  const double away = descend(X_DE, arm, kMaxJointSteps);
  if (away < kOutOfReach) return away;
  // Out of reach, or on a branch of the arm from which there is no way: from home there may be one.
  Posture anew = posture(home_);
  const double away_anew = descend(X_DE, anew, kMaxJointSteps);
  if (!(away_anew < kOutOfReach)) return away;
  arm = anew;
  return away_anew;
}

}  // namespace fulcrum
