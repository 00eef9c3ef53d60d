#include "haptics/tool/virtual_coupling.h"

#include <algorithm>
#include <cmath>

#include "haptics/math/clamp_norm.h"
#include "haptics/math/functions.h"
#include "haptics/math/rotation.h"

namespace fulcrum {
namespace {

constexpr double kUnbent = 1e-9;  // of a spring's limit, up to which it is a straight one to rounding

}  // namespace

VirtualCoupling::VirtualCoupling(const CouplingDesc& desc, const RigidBody& tool)
    : desc_(desc),
      damping_(2.0 * desc.damping_ratio * std::sqrt(desc.stiffness * tool.mass())),
      angular_damping_(2.0 * desc.damping_ratio * std::sqrt(desc.angular_stiffness)),
      tool_(tool) {}

// The damper is critical for the mass that the tool has at the end of its longest grip, where that is least.
VirtualCoupling::VirtualCoupling(const CouplingDesc& desc, const RigidBody& tool, const Vec3& longest_grip)
    : VirtualCoupling(desc, tool) {
  damping_ = 2.0 * desc.damping_ratio * std::sqrt(desc.stiffness * tool.least_mass_at(longest_grip));
}

Wrench VirtualCoupling::pull(const Pose& X_WG, const Twist& V_WG, const BodyState& tool) noexcept {
  rotation_ = rotation_vector_near(X_WG.q * tool.X_WT.q.conjugate(), rotation_);
  offset_ = X_WG.p - tool.X_WT.p;
  if (!held_at_T_) return pull_at_grip(X_WG, V_WG, tool);
  Wrench F;
  // The sum is bounded too: a hand that flies past a held tool would push it with its damper alone.
  F.force =
      saturated_spring(offset_, desc_.stiffness, desc_.max_force, pulls_) - damping_ * (tool.V_WT.v - V_WG.v);
  F.torque = saturated_spring(rotation_, desc_.angular_stiffness, desc_.max_torque, twists_) -
             angular_damping_ * (tool_.root_inertia_W(tool.X_WT.q) * (tool.V_WT.w - V_WG.w));
  F.force = clamp_norm(F.force, desc_.max_force);
  full_torque_ = clamp_norm(F.torque, desc_.max_torque);
  F.torque = clamp_norm(full_torque_, torque_limit_);
  return F;
}

Wrench VirtualCoupling::pull_at_grip(const Pose& X_WG, const Twist& V_WG, const BodyState& tool) noexcept {
  lever_W_ = tool.X_WT.q * p_TG_;
  const Vec3 wanted_lever_W = X_WG.q * p_TG_;
  offset_ += wanted_lever_W - lever_W_;
  const Vec3 v_W = tool.V_WT.v + tool.V_WT.w.cross(lever_W_);
  const Vec3 wanted_v_W = V_WG.v + V_WG.w.cross(wanted_lever_W);
  Wrench F;
  F.force = clamp_norm(
      saturated_spring(offset_, desc_.stiffness, desc_.max_force, pulls_) - damping_ * (v_W - wanted_v_W),
      desc_.max_force);
  const Vec3 torque = saturated_spring(rotation_, desc_.angular_stiffness, desc_.max_torque, twists_) -
                      angular_damping_ * (tool_.root_inertia_W(tool.X_WT.q) * (tool.V_WT.w - V_WG.w));
  full_torque_ = clamp_norm(torque, desc_.max_torque);
  moment_ = lever_W_.cross(F.force);
  F.torque = clamp_norm(full_torque_, torque_limit_) + moment_;
  return F;
}

void VirtualCoupling::linearise(const BodyState& tool, Linearisation& around) const noexcept {
  const double k = desc_.stiffness * math::exp(-desc_.stiffness * offset_.norm() / desc_.max_force);
  const double full = full_torque_.norm();
  const double part = full > torque_limit_ ? torque_limit_ / full : 1.0;  // of torque, where it is limited
  const double k_R = part * desc_.angular_stiffness *
                     math::exp(-desc_.angular_stiffness * rotation_.norm() / desc_.max_torque);
  around.K.topLeftCorner<3, 3>().diagonal().array() += k;
  around.K.bottomRightCorner<3, 3>().diagonal().array() += k_R;
  around.B.topLeftCorner<3, 3>().diagonal().array() += damping_;
  if (!held_at_T_) {
    Mat3 turned;  // of the velocity of G by that of the tool: v_G = v + turned w
    turned << 0, lever_W_.z(), -lever_W_.y(), -lever_W_.z(), 0, lever_W_.x(), lever_W_.y(), -lever_W_.x(), 0;
    const auto add = [&turned](Mat6& to, double gain) {
      to.topRightCorner<3, 3>() += gain * turned;
      to.bottomLeftCorner<3, 3>() += gain * turned.transpose();
      to.bottomRightCorner<3, 3>() += gain * (turned.transpose() * turned);
    };
    add(around.K, k);
    add(around.B, damping_);
  }
  around.B.bottomRightCorner<3, 3>() += part * angular_damping_ * tool_.root_inertia_W(tool.X_WT.q);
}

double VirtualCoupling::stored() const noexcept {
  const double turn = rotation_.norm();
  const double k_R = desc_.angular_stiffness, most = desc_.max_torque;
  // Beyond this turn the torque is the limit and stays so.
  const double yields =
      torque_limit_ < most ? std::min(turn, -most / k_R * math::log1p(-torque_limit_ / most)) : turn;
  const double beyond = turn > yields ? torque_limit_ * (turn - yields) : 0.0;
  const double twisted = yields == turn ? saturated_spring_energy(turn, k_R, most, twists_)
                                        : saturated_spring_energy(yields, k_R, most);
  return saturated_spring_energy(offset_.norm(), desc_.stiffness, desc_.max_force, pulls_) + twisted + beyond;
}

Vec3 saturated_spring(const Vec3& d, double stiffness, double limit, double& part) noexcept {
  const double length = d.norm();
  const double x = stiffness * length / limit;
  part = -math::expm1(-x);
  if (x < kUnbent) return stiffness * d;
  return d * (limit * part / length);
}

Vec3 saturated_spring(const Vec3& d, double stiffness, double limit) noexcept {
  if (stiffness * d.norm() / limit < kUnbent) return stiffness * d;
  double part = 0;
  return saturated_spring(d, stiffness, limit, part);
}

double saturated_spring_energy(double length, double stiffness, double limit, double part) noexcept {
  return limit * length - limit * limit / stiffness * part;
}

double saturated_spring_energy(double length, double stiffness, double limit) noexcept {
  return saturated_spring_energy(length, stiffness, limit, -math::expm1(-stiffness * length / limit));
}

}  // namespace fulcrum
