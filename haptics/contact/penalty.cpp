#include "haptics/contact/penalty.h"

#include <algorithm>

namespace fulcrum {

PenaltyResponse::PenaltyResponse(const ContactDesc& desc, const RigidBody& tool, double tick_s,
                                 Integrator integrator)
    : desc_(desc), tool_(tool), tick_s_(tick_s), capped_(integrator != Integrator::implicit_euler) {}

PenaltyResponse::Answer PenaltyResponse::push(const ContactSet& set, const BodyState& tool) noexcept {
  const std::span<const Contact> contacts = set.contacts();
  count_ = contacts.size();
  if (contacts.empty()) return {};
  share_stiffness(contacts);
  const Scale scale = capped_ ? cap(contacts, tool) : Scale{};

  Answer answer;
  answer.stiffness_capped = scale.stiffness < 1.0;
  const double dissipation = scale.dissipation * desc_.dissipation;
  for (std::size_t i = 0; i < count_; ++i) {
    const Vec3 r_W = pressed_W_[i] - tool.X_WT.p;
    const double approach = -contacts[i].nhat_W.dot(tool.V_WT.v + tool.V_WT.w.cross(r_W));
    const double grip = std::max(0.0, 1.0 + dissipation * approach);
    stiffness_[i] = scale.stiffness * share_[i] * desc_.stiffness;
    damping_[i] = grip > 0 ? stiffness_[i] * contacts[i].overlap.mean_depth() * dissipation : 0.0;
    force_[i] = contacts[i].nhat_W * (stiffness_[i] * contacts[i].overlap.mean_depth() * grip);
    answer.F_T_W += {force_[i], r_W.cross(force_[i])};
  }
  return answer;
}

PenaltyResponse::Scale PenaltyResponse::cap(std::span<const Contact> contacts,
                                            const BodyState& tool) const noexcept {
  const Mat3 inverse_inertia_W = tool_.inverse_inertia_W(tool.X_WT.q);
  double stiffness_over_mass = 0, damping_over_mass = 0;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Vec3 arm = (pressed_W_[i] - tool.X_WT.p).cross(contacts[i].nhat_W);
    const double inverse_mass = 1.0 / tool_.mass() + arm.dot(inverse_inertia_W * arm);
    const double k = share_[i] * desc_.stiffness;
    stiffness_over_mass += k * inverse_mass;
    damping_over_mass += k * contacts[i].overlap.mean_depth() * desc_.dissipation * inverse_mass;
  }
  Scale scale;
  scale.stiffness = std::min(1.0, kStiffnessShare / (tick_s_ * tick_s_ * stiffness_over_mass));
  const double damping = scale.stiffness * damping_over_mass;
  scale.dissipation = damping > 0 ? std::min(1.0, kDampingShare / (tick_s_ * damping)) : 0.0;
  return scale;
}

void PenaltyResponse::linearise(const ContactSet& set, const BodyState& tool,
                                Linearisation& around) const noexcept {
  for (std::size_t i = 0; i < count_; ++i) {
    const Contact& contact = set.contacts()[i];
    Vec6 direction;
    direction << contact.nhat_W, (pressed_W_[i] - tool.X_WT.p).cross(contact.nhat_W);
    around.add_along(direction, stiffness_[i], damping_[i]);
  }
}

void PenaltyResponse::share_stiffness(std::span<const Contact> contacts) noexcept {
  const double radius_squared = desc_.region_radius * desc_.region_radius;
  std::array<double, kMaxContacts> around;  // each: the overlap of those near it, itself among them
  for (std::size_t i = 0; i < count_; ++i) {
    pressed_W_[i] = contacts[i].pressed_W();
    around[i] = contacts[i].overlap.volume;
  }
  for (std::size_t i = 0; i < count_; ++i) {
    for (std::size_t j = i + 1; j < count_; ++j) {
      const double apart = (pressed_W_[i] - pressed_W_[j]).squaredNorm();
      if (apart >= radius_squared) continue;
      const double alike = std::max(0.0, contacts[i].nhat_W.dot(contacts[j].nhat_W));
      const double near = 1.0 - apart / radius_squared;
      const double weight = alike * near * near;
      around[i] += weight * contacts[j].overlap.volume;
      around[j] += weight * contacts[i].overlap.volume;
    }
  }
  for (std::size_t i = 0; i < count_; ++i)
    share_[i] = around[i] > 0 ? contacts[i].overlap.volume / around[i] : 0.0;
}

}  // namespace fulcrum
