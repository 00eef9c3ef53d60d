#include "haptics/motion/quasi_static_tool.h"

#include "haptics/math/functions.h"

namespace fulcrum {

namespace {

// What the coupling's damper has to brake where the tool has no mass: the handle, as the scene feels it.
RigidBody handle_in_scene(const PlainScene& desc) {
  const double mass = desc.mapping.mass_in_world(desc.device.handle_mass);
  const Vec3 inertia = desc.device.handle_inertia.unaryExpr(
      [&desc](double about) { return desc.mapping.inertia_in_world(about); });
  if (inertia.isConstant(inertia.x(), 0)) return {mass, Mat3::Identity() * inertia.x()};
  const Mat3 R_TH = desc.tool.X_HT.q.conjugate().toRotationMatrix();
  return {mass, R_TH * inertia.asDiagonal() * R_TH.transpose()};
}

}  // namespace

QuasiStaticTool::QuasiStaticTool(const PlainScene& desc)
    : coupling_(desc.coupling, handle_in_scene(desc)),
      velocity_(desc.velocity, desc.tick_s),
      tick_s_(desc.tick_s),
      weight_(tool_weight(desc.tool)),
      // F_s (1 - exp(-k sag / F_s)) = weight
      sag_(-desc.coupling.max_force / desc.coupling.stiffness *
           math::log1p(-weight_ / desc.coupling.max_force)) {
  state_.X_WT = desc.tool.X_WT_start;
  if (!desc.tool_features) state_.X_WT.p.y() -= sag_;  // between real walls there may be no room for that
}

Vec6 QuasiStaticTool::to_hand(const Pose& X_WG) noexcept {
  turn_ = rotation_vector_near(X_WG.q * state_.X_WT.q.conjugate(), turn_);
  Vec6 d;
  d << X_WG.p - state_.X_WT.p, turn_;
  return d;
}

Vec6 QuasiStaticTool::to_goal(const Pose& X_WG) noexcept {
  Vec6 d = to_hand(X_WG);
  d[1] -= sag_;
  return d;
}

bool QuasiStaticTool::move(const Vec6& d) noexcept {
  const Pose X_WT = RigidBody::advance(state_.X_WT, {d.head<3>(), d.tail<3>()}, 1.0);
  if (!X_WT.is_finite()) return false;
  state_.X_WT = X_WT;
  return true;
}

Wrench QuasiStaticTool::settle(const Pose& X_WG, const Twist& V_WG, bool is_late) noexcept {
  Vec6 with_hand;
  with_hand << tick_s_ * V_WG.v, tick_s_ * V_WG.w;
  state_.V_WT = is_late ? velocity_.update(state_.X_WT, with_hand) : velocity_.update(state_.X_WT);
  return coupling_.pull(X_WG, V_WG, state_);
}

}  // namespace fulcrum
