#include "haptics/motion/direct_motion.h"

#include "haptics/math/number_text.h"
#include "haptics/motion/query_part.h"
#include "haptics/safety/faults.h"

namespace fulcrum {

DirectMotion::DirectMotion(const PlainScene& desc)
    : stiffness_(desc.contact.stiffness),
      scale_(desc.mapping.position_scale * desc.mapping.force_scale),
      weight_(tool_weight(desc.tool)),
      query_(desc.tool_shell, desc.scene_field),
      regions_(desc.contact.region_radius) {
  tool_.X_WT = desc.tool.X_WT_start;
}

ToolAnswer DirectMotion::advance(const Pose& X_WG, const Twist& V_WG, std::uint32_t& faults) noexcept {
  tool_ = {X_WG, V_WG};
  const ContactQuery::Outcome outcome = query_.run(tool_.X_WT, contacts_);
  if (!outcome.complete) faults |= kContactsReduced;
  if (!outcome.in_band) faults |= kToolInside;
  ToolAnswer answer;
  answer.X_WT = tool_.X_WT;
  answer.contact_F_T_W = contact_wrench();
  // The hand holds what is left.
  answer.coupling_F_T_W = -answer.contact_F_T_W;
  answer.coupling_F_T_W.force.y() += weight_;
  answer.full_torque_T_W = answer.coupling_F_T_W.torque;
  return answer;
}

Wrench DirectMotion::contact_wrench() noexcept {
  const std::span<const Contact> contacts = contacts_.contacts();
  const std::span<const std::uint16_t> region_of = regions_.find(contacts);
  std::array<std::size_t, kMaxRegions> deepest;  // of each region; a contact's number
  deepest.fill(contacts.size());
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    std::size_t& at = deepest[region_of[i]];
    if (at == contacts.size() || contacts[i].depth > contacts[at].depth) at = i;
    forces_[i].setZero();
  }
  Wrench F_T_W;
  stored_ = 0;
  for (const std::size_t i : deepest) {
    if (i == contacts.size()) continue;
    const Contact& contact = contacts[i];
    forces_[i] = stiffness_ * contact.depth * contact.nhat_W;
    F_T_W += {forces_[i], Vec3(contact.p_W - tool_.X_WT.p).cross(forces_[i])};
    stored_ += 0.5 * stiffness_ * contact.depth * contact.depth;
  }
  regions_.describe(contacts, {forces_.data(), contacts.size()}, tool_);
  return F_T_W;
}

bool DirectMotion::stiffen(double stiffness) noexcept {
  if (!regions_.regions().empty()) return false;
  stiffness_ = stiffness;
  return true;
}

std::vector<BuiltPart> DirectMotion::parts() const {
  return {
      query_part(query_),
      {"response",
       "direct: the tool is where the hand wants it, " + number_text(stiffness_) +
           " N/m from the deepest point of each region to the surface, at most " +
           std::to_string(kMaxRegions) + " regions; the device renders " + number_text(scale_ * stiffness_) +
           " N/m; one without motors gets a constraint and a coupling as stiff instead",
       sizeof(DirectMotion)},
  };
}

}  // namespace fulcrum
