#include "haptics/actuation/mechanism.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

// J^-T, with singular values no smaller than kMinLever.
JointChain::Jacobian inverse_transposed(const JointChain::Jacobian& J) noexcept {
  const JointChain::Jacobian inverse = J.partialPivLu().inverse();
  if (inverse.norm() * Mechanism::kMinLever < 1) return inverse.transpose();  // false for what is no number
  const Eigen::JacobiSVD<JointChain::Jacobian, Eigen::NoQRPreconditioner> svd(
      J, Eigen::ComputeFullU | Eigen::ComputeFullV);  // it is square: there is nothing to precondition
  return svd.matrixU() * svd.singularValues().cwiseMax(Mechanism::kMinLever).cwiseInverse().asDiagonal() *
         svd.matrixV().transpose();
}

const JointDesc* joint_of(const MechanismDesc& desc, int motor) {
  for (const ArmDesc& arm : desc.arms) {
    const int joints = static_cast<int>(arm.joints.size());
    if (motor < joints) return &arm.joints[static_cast<std::size_t>(motor)];
    motor -= joints;
  }
  return nullptr;  // the spin's
}

JointAngles home_of(const ArmDesc& arm) {
  JointAngles home{};
  for (std::size_t j = 0; j < arm.joints.size(); ++j) home[j] = arm.joints[j].home;
  return home;
}

std::optional<Error> refuse_joint(const ArmDesc& arm, std::size_t j) {
  const JointDesc& joint = arm.joints[j];
  const std::string name = "The joint '" + joint.name + "' ";
  if (!(joint.axis_K.norm() > 0)) return Error{name + "has no axis: give a direction."};
  if (!(joint.low <= joint.home && joint.home <= joint.high))
    return Error{name + "is at home outside of its stops: 'home' must be from 'low' to 'high'."};
  if (joint.through_parallelogram && j == 0)
    return Error{name + "is the first of its arm: no parallelogram can lead to it."};
  return std::nullopt;
}

}  // namespace

std::optional<Error> Mechanism::refuse(const MechanismDesc& desc) {
  if (desc.arms.empty() || desc.arms.size() > 2)
    return Error{"A device of kinematics 'arms' has one arm or two: give them in 'arms'."};
  for (const ArmDesc& arm : desc.arms) {
    if (arm.joints.size() != 3 && !(arm.joints.size() == 6 && desc.arms.size() == 1))
      return Error{"The arm '" + arm.name +
                   "' must have three joints, and hold the handle by a gimbal; or six, and be the only one."};
    for (std::size_t j = 0; j < arm.joints.size(); ++j)
      if (auto error = refuse_joint(arm, j)) return error;
  }
  if (!desc.spin) return std::nullopt;
  if (desc.arms.size() != 2)
    return Error{"A spin turns the handle about the line between two arms' ends: it needs two arms."};
  const auto end = [&desc](std::size_t arm) {
    return JointChain(desc.arms[arm], Pose{}).place(home_of(desc.arms[arm])).X_DE.p;
  };
  constexpr double coincident = 1e-6;  // m
  if ((end(0) - end(1)).norm() < coincident)
    return Error{
        "Both arms end at the same point at home, so that no line between them could be turned about."};
  return std::nullopt;
}

int Mechanism::motors(const MechanismDesc& desc) {
  std::size_t motors = desc.spin ? 1 : 0;
  for (const ArmDesc& arm : desc.arms) motors += arm.joints.size();
  return static_cast<int>(motors);
}

std::string Mechanism::motor_name(const MechanismDesc& desc, int motor) {
  const JointDesc* joint = joint_of(desc, motor);
  return joint != nullptr ? joint->name : desc.spin->name;
}

double Mechanism::motor_limit(const MechanismDesc& desc, int motor) {
  const JointDesc* joint = joint_of(desc, motor);
  return joint != nullptr ? joint->max_torque : desc.spin->max_torque;
}

Mechanism::Mechanism(const MechanismDesc& desc) {
  const ArmDesc& first = desc.arms.front();
  const Vec3 home = JointChain(first, {desc.q_DK, Vec3::Zero()}).place(home_of(first)).X_DE.p;
  const Pose X_DK{desc.q_DK, -home};
  for (const ArmDesc& arm : desc.arms) {
    const JointChain chain(arm, X_DK);
    const JointChain::Posture at_home = chain.posture(chain.home());
    arms_.push_back({chain, at_home.placed.X_DE, at_home});
  }
  if (desc.spin) spin_H_ = (arms_[1].X_HE.p - arms_[0].X_HE.p).normalized() / desc.spin->ratio;
  follow(Pose{});
}

void Mechanism::follow(const Pose& X_DH) noexcept {
  out_of_reach_ = 0;
  q_DH_ = X_DH.q;
  int column = 0;
  for (Arm& arm : arms_) {
    out_of_reach_ = std::max(out_of_reach_, arm.chain.reach(X_DH * arm.X_HE, arm.posture));
    write_columns(arm, X_DH, column);
    column += arm.chain.joints();
  }
  if (spin_H_) wrenches_.col(column) << Vec3::Zero(), X_DH.q * *spin_H_;
}

void Mechanism::write_columns(const Arm& arm, const Pose& X_DH, int first) noexcept {
  const int joints = arm.chain.joints();
  JointChain::Jacobian J = arm.chain.jacobian(arm.posture.placed);
  for (int j = joints - 1; j > 0; --j)  // the last one first: the next goes by what it has become
    if (arm.chain.through_parallelogram(j)) J.col(j - 1) -= J.col(j);
  if (joints == 3) {
    const JointChain::Jacobian pushes = inverse_transposed(J);
    const Vec3 lever = X_DH.q * arm.X_HE.p;
    for (int j = 0; j < 3; ++j) {
      const Vec3 force = pushes.col(j);
      wrenches_.col(first + j) << force, lever.cross(force);
    }
    return;
  }
  twists_.leftCols<6>() = J;
  J.bottomRows<3>() *= JointChain::kLever;
  const JointChain::Jacobian pushes = inverse_transposed(J);
  // The end of the only arm is H's origin.
  wrenches_.topLeftCorner<3, 6>() = pushes.topRows<3>();
  wrenches_.bottomLeftCorner<3, 6>() = JointChain::kLever * pushes.bottomRows<3>();
}

WrenchMatrix Mechanism::jacobian(const Vec3& p_HG) const noexcept {
  WrenchMatrix J;
  const Mat3 R_HD = q_DH_.conjugate().toRotationMatrix();
  for (Eigen::Index motor = 0; motor < J.cols(); ++motor) {
    const Vec3 w = R_HD * twists_.col(motor).tail<3>();
    J.col(motor) << R_HD * twists_.col(motor).head<3>() + w.cross(p_HG), w;
  }
  return J;
}

const JointChain::Placed& Mechanism::placed(int arm) const noexcept {
  return arms_[static_cast<std::size_t>(arm)].posture.placed;
}

}  // namespace fulcrum
