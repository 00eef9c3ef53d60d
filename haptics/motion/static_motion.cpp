#include "haptics/motion/static_motion.h"

#include <Eigen/Cholesky>

#include "haptics/math/number_text.h"
#include "haptics/motion/motion_limit.h"
#include "haptics/safety/faults.h"

namespace fulcrum {
namespace {

// Nothing moves by itself here, so contact has springs alone.
ContactDesc springs_alone(ContactDesc contact) {
  contact.dissipation = 0;
  return contact;
}

BodyState at_rest(const Pose& X_WT) {
  return {X_WT, {}};
}

}  // namespace

StaticMotion::StaticMotion(const SceneDesc& desc)
    : contact_(springs_alone(desc.contact)),
      tool_(desc),
      query_(desc.tool_shell, desc.scene_field),
      response_(contact_, RigidBody(desc.tool.mass, desc.tool.inertia_T), desc.tick_s,
                Integrator::implicit_euler),
      regions_(desc.contact.region_radius),
      allowance_(motion_allowance(*desc.scene_field)) {
  coupling_stiffness_.head<3>().setConstant(desc.coupling.stiffness);
  coupling_stiffness_.tail<3>().setConstant(desc.coupling.angular_stiffness);
}

ToolAnswer StaticMotion::advance(const Pose& X_WG, const Twist& V_WG, std::uint32_t& faults) noexcept {
  if (!looked_) outcome_ = query_.run(tool_.state().X_WT, contacts_);
  looked_ = true;
  const Vec6 step = newton_step(X_WG);
  const double fraction = query_.safe_fraction(step.head<3>().norm(), step.tail<3>().norm(), allowance_);
  if (fraction < 1.0) faults |= kMotionLimited;
  if (!tool_.move(step * fraction)) faults |= kNotFinite;
  outcome_ = query_.run(tool_.state().X_WT, contacts_);
  if (!outcome_.complete) faults |= kContactsReduced;
  if (!outcome_.in_band) faults |= kToolInside;

  ToolAnswer answer;
  answer.X_WT = tool_.state().X_WT;
  answer.contact_F_T_W = response_.push(contacts_, at_rest(answer.X_WT)).F_T_W;
  answer.coupling_F_T_W = tool_.settle(X_WG, V_WG);
  regions_.update(contacts_.contacts(), response_.forces(), tool_.state());
  return answer;
}

// The coupling is taken as linear: where it saturates, the balance is the one of the springs as they were
// before, and it is the hand that feels less.
Vec6 StaticMotion::newton_step(const Pose& X_WG) noexcept {
  const BodyState tool = at_rest(tool_.state().X_WT);
  const Wrench contact = response_.push(contacts_, tool).F_T_W;
  Linearisation around;
  response_.linearise(contacts_, tool, around);
  around.K.diagonal() += coupling_stiffness_;
  Vec6 force;
  force << contact.force, contact.torque;
  force += coupling_stiffness_.cwiseProduct(tool_.to_goal(X_WG));
  return around.K.ldlt().solve(force);
}

std::vector<BuiltPart> StaticMotion::parts() const {
  return {
      {"query", "every point against the field, culled by the tool's reach", query_.bytes()},
      {"response",
       "static: one 6 x 6 balance a tick, " + number_text(contact_.stiffness) + " N/m per region, at most " +
           std::to_string(kMaxContacts) + " points in " + std::to_string(kMaxRegions) + " regions",
       sizeof(StaticMotion)},
  };
}

}  // namespace fulcrum
