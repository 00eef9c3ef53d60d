#include "haptics/motion/quasi_static_motion.h"

#include <Eigen/Cholesky>

#include "haptics/math/clamp_norm.h"
#include "haptics/math/number_text.h"
#include "haptics/motion/motion_limit.h"
#include "haptics/motion/query_part.h"
#include "haptics/safety/faults.h"

namespace fulcrum {
namespace {

// An even number: stiff contact is balanced within the rounding of a distance, and a step that begins just
// outside goes in, the next one back out to the balance.
constexpr int kMaxSteps = 4;             // at most, in a tick
constexpr double kSettledStep = 0.1e-6;  // m, a step that moves no point farther ends the tick

// Nothing moves by itself here, so contact has springs alone.
ContactDesc springs_alone(ContactDesc contact) {
  contact.dissipation = 0;
  return contact;
}

double secant(const Vec3& force, const Vec3& d, double stiffness) {
  const double length = d.norm();
  return length > 0 ? force.norm() / length : stiffness;
}

BodyState at_rest(const Pose& X_WT) {
  return {X_WT, {}};
}

}  // namespace

QuasiStaticMotion::QuasiStaticMotion(const PlainScene& desc)
    : coupling_(desc.coupling),
      tool_(desc),
      query_(desc.tool_shell, desc.scene_field),
      response_(springs_alone(desc.contact), RigidBody(desc.tool.mass, desc.tool.inertia_T), desc.tick_s,
                Integrator::implicit_euler),
      regions_(desc.contact.region_radius),
      allowance_(motion_allowance(*desc.scene_field)),
      tool_radius_(desc.tool_shell->max_radius_m) {
  if (has_friction(desc.contact)) friction_.emplace(desc.contact);
}

ToolAnswer QuasiStaticMotion::advance(const Pose& X_WG, const Twist& V_WG, std::uint32_t& faults) noexcept {
  if (!looked_) outcome_ = query_.run(tool_.state().X_WT, contacts_);
  looked_ = true;
  bool limited = false;
  for (int round = 0; round < kMaxSteps; ++round) {
    const Vec6 step = newton_step(X_WG);
    const double travel = step.head<3>().norm(), turn = step.tail<3>().norm();
    const double fraction = query_.safe_fraction(travel, turn, allowance_);
    limited = fraction < 1.0;
    if (!tool_.move(step * fraction)) {
      faults |= kNotFinite;
      break;
    }
    outcome_ = query_.run(tool_.state().X_WT, contacts_);
    if (travel + turn * tool_radius_ < kSettledStep) break;
  }
  if (limited) faults |= kMotionLimited;
  if (!outcome_.complete) faults |= kContactsReduced;
  if (!outcome_.in_band) faults |= kToolInside;

  ToolAnswer answer;
  answer.X_WT = tool_.state().X_WT;
  answer.contact_F_T_W = contact_wrench(at_rest(answer.X_WT));
  answer.coupling_F_T_W = tool_.settle(X_WG, V_WG, false);
  answer.full_torque_T_W = tool_.coupling().full_torque();
  answer.turn_W = tool_.coupling().turn();
  regions_.update(contacts_.contacts(), response_.forces(), tool_.state());
  if (friction_) {
    friction_->keep(tool_.state());
    regions_.add_forces(friction_->forces());
  }
  return answer;
}

Wrench QuasiStaticMotion::contact_wrench(const BodyState& tool) noexcept {
  Wrench F_T_W = response_.push(contacts_, tool).F_T_W;
  if (!friction_) return F_T_W;
  const std::span<const Contact> contacts = contacts_.contacts();
  return F_T_W + friction_->rub(
                     {contacts, regions_.find(contacts), response_.forces(), response_.stiffnesses()}, tool);
}

// The coupling's springs saturate; their secants take the tool all the way through free space in one step and
// converge to the balance from any side.
Vec6 QuasiStaticMotion::newton_step(const Pose& X_WG) noexcept {
  const BodyState tool = at_rest(tool_.state().X_WT);
  const Wrench contact = contact_wrench(tool);
  Linearisation around;
  response_.linearise(contacts_, tool, around);
  if (friction_) friction_->linearise(around);
  const Vec6 d = tool_.to_hand(X_WG);
  const Vec3 pull = saturated_spring(d.head<3>(), coupling_.stiffness, coupling_.max_force);
  const Vec3 twist =
      clamp_norm(saturated_spring(d.tail<3>(), coupling_.angular_stiffness, coupling_.max_torque),
                 tool_.coupling().torque_limit());
  around.K.diagonal().head<3>().array() += secant(pull, d.head<3>(), coupling_.stiffness);
  around.K.diagonal().tail<3>().array() += secant(twist, d.tail<3>(), coupling_.angular_stiffness);
  Vec6 force;
  force << contact.force + pull, contact.torque + twist;
  force[1] -= tool_.weight();
  return around.K.ldlt().solve(force);
}

bool QuasiStaticMotion::stiffen(double stiffness) noexcept {
  if (!contacts_.contacts().empty()) return false;
  response_.stiffen(stiffness);
  return true;
}

std::vector<BuiltPart> QuasiStaticMotion::parts() const {
  std::vector<BuiltPart> parts{
      query_part(query_),
      {"response",
       "static: at most " + std::to_string(kMaxSteps) + " 6 x 6 steps a tick, " +
           number_text(response_.stiffness()) + " N/m per region, at most " + std::to_string(kMaxContacts) +
           " points in " + std::to_string(kMaxRegions) + " regions",
       sizeof(QuasiStaticMotion)},
  };
  if (friction_) parts.push_back({"friction", friction_->note(), sizeof(*friction_)});
  return parts;
}

}  // namespace fulcrum
