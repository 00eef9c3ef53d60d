#include "haptics/motion/dynamic_motion.h"

#include "haptics/math/number_text.h"
#include "haptics/motion/motion_limit.h"
#include "haptics/motion/query_part.h"
#include "haptics/safety/faults.h"

namespace fulcrum {
namespace {

const char* integrator_text(Integrator integrator) {
  switch (integrator) {
    case Integrator::semi_implicit_euler:
      return "semi-implicit Euler, order 1";
    case Integrator::implicit_euler:
      return "implicit Euler, order 1";
    case Integrator::momentum:
      break;
  }
  return "semi-implicit Euler, order 1, rotation of order 2 that keeps momentum";
}

VirtualCoupling coupling_of(const PlainScene& desc, const RigidBody& tool) {
  return desc.holding_point ? VirtualCoupling(desc.coupling, tool, longest_grip(desc))
                            : VirtualCoupling(desc.coupling, tool);
}

}  // namespace

DynamicMotion::DynamicMotion(const PlainScene& desc)
    : tick_s_(desc.tick_s),
      integrator_(desc.integrator),
      body_(desc.tool.mass, desc.tool.inertia_T),
      weight_(tool_weight(desc.tool)),
      query_(desc.tool_shell, desc.scene_field),
      response_(desc.contact, body_, desc.tick_s, desc.integrator),
      regions_(desc.contact.region_radius),
      coupling_(coupling_of(desc, body_)),
      motion_allowance_(motion_allowance(*desc.scene_field)) {
  tool_.X_WT = desc.tool.X_WT_start;
  if (has_friction(desc.contact)) friction_.emplace(desc.contact, body_, desc.tick_s);
  if (desc.contact.response == ContactResponse::voxel) voxels_.emplace(desc.tool_shell, desc.scene_field);
}

ToolAnswer DynamicMotion::advance(const Pose& X_WG, const Twist& V_WG, std::uint32_t& faults) noexcept {
  ToolAnswer answer;
  answer.X_WT = tool_.X_WT;
  answer.contact_F_T_W = contact_wrench(faults);
  answer.coupling_F_T_W = coupling_.pull(X_WG, V_WG, tool_);
  answer.full_torque_T_W = coupling_.full_torque();
  answer.turn_W = coupling_.turn();
  Wrench F_T_W = answer.coupling_F_T_W + answer.contact_F_T_W;
  F_T_W.force.y() -= weight_;
  move(F_T_W, faults);
  return answer;
}

Wrench DynamicMotion::contact_wrench(std::uint32_t& faults) noexcept {
  ContactQuery::Outcome outcome = query_.run(tool_.X_WT, contacts_);
  if (voxels_) outcome = voxels_->run(tool_.X_WT, contacts_);
  if (!outcome.complete) faults |= kContactsReduced;
  if (!outcome.in_band) faults |= kToolInside;
  const PenaltyResponse::Answer answer = response_.push(contacts_, tool_);
  if (answer.stiffness_capped) faults |= kStiffnessCapped;
  regions_.update(contacts_.contacts(), response_.forces(), tool_);
  if (!friction_) return answer.F_T_W;
  const auto& [contacts, region_of, regions] = touching();
  const Wrench rubbing_F_T_W =
      friction_->rub({contacts, region_of, response_.forces(), response_.stiffnesses()}, tool_);
  friction_->keep(tool_);
  regions_.add_forces(friction_->forces());
  return answer.F_T_W + rubbing_F_T_W;
}

RigidBody::Move DynamicMotion::accelerated(const Wrench& F_T_W) const noexcept {
  switch (integrator_) {
    case Integrator::semi_implicit_euler: {
      const Twist V_WT = body_.accelerate(tool_, F_T_W, tick_s_);
      return {V_WT, V_WT};
    }
    case Integrator::momentum:
      return body_.accelerate_keeping_momentum(tool_, F_T_W, tick_s_);
    case Integrator::implicit_euler:
      break;
  }
  Linearisation around;
  response_.linearise(contacts_, tool_, around);
  if (friction_) friction_->linearise(around);
  coupling_.linearise(tool_, around);
  const Twist V_WT = body_.accelerate(tool_, F_T_W, around, tick_s_);
  return {V_WT, V_WT};
}

void DynamicMotion::move(const Wrench& F_T_W, std::uint32_t& faults) noexcept {
  RigidBody::Move move = accelerated(F_T_W);
  const double safe =
      query_.safe_fraction(move.during.v.norm() * tick_s_, move.during.w.norm() * tick_s_, motion_allowance_);
  if (safe < 1.0) {
    faults |= kMotionLimited;
    for (Twist* V_WT : {&move.during, &move.after}) {
      V_WT->v *= safe;
      V_WT->w *= safe;
    }
  }
  const Pose X_WT = RigidBody::advance(tool_.X_WT, move.during, tick_s_);
  if (!X_WT.is_finite() || !move.after.v.allFinite() || !move.after.w.allFinite()) {
    faults |= kNotFinite;
    tool_.V_WT = {};
    return;
  }
  tool_.X_WT = X_WT;
  tool_.V_WT = move.after;
}

bool DynamicMotion::stiffen(double stiffness) noexcept {
  if (!contacts_.contacts().empty()) return false;
  response_.stiffen(stiffness);
  return true;
}

double DynamicMotion::stored_energy() const noexcept {
  return coupling_.stored() + body_.kinetic_energy(tool_);
}

std::vector<BuiltPart> DynamicMotion::parts() const {
  std::vector<BuiltPart> parts{
      query_part(query_),
      {"response",
       "penalty, " + number_text(response_.stiffness()) + " N/m per region, at most " +
           std::to_string(kMaxContacts) + " points in " + std::to_string(kMaxRegions) + " regions",
       sizeof(PenaltyResponse) + sizeof(RegionTracker) + kMaxContacts * sizeof(Contact)},
      {"integrator",
       std::string(integrator_text(integrator_)) + ", tick " + number_text(tick_s_ * 1e3) + " ms",
       sizeof(BodyState)},
  };
  if (friction_) parts.push_back({"friction", friction_->note(), sizeof(*friction_)});
  if (voxels_)
    parts.push_back({"voxels", "occupied or not, for depths by the classic method", voxels_->bytes()});
  return parts;
}

}  // namespace fulcrum
