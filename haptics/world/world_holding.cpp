// Where the hand holds the tool, and what the device's mass does to it.

#include <algorithm>
#include <cmath>

#include "haptics/world/world.h"

namespace fulcrum {
namespace {

constexpr double kFirstReading = 0.1;  // s, from the start: by then a strip has been read and trusted

double nearest(std::span<const double> levels, double to) {
  return *std::min_element(levels.begin(), levels.end(),
                           [to](double a, double b) { return std::abs(a - to) < std::abs(b - to); });
}

}  // namespace

void World::obey(std::span<const Command> commands) noexcept {
  for (const Command& command : commands) {
    if (torque_substitution_) torque_substitution_->obey(command);
    if (impact_vibration_) impact_vibration_->obey(command);
    if (braking_pulse_) braking_pulse_->obey(command);
    if (vibrotactile_motion_) vibrotactile_motion_->obey(command);
    if (holding_point_) tell_holding_point(command);
    if (inertia_compensation_) inertia_compensation_->obey(command);
    if (command.kind == Command::Kind::contact_stiffness && !desc_.contact.levels.empty() &&
        std::isfinite(command.value))
      stiffness_wanted_ = nearest(desc_.contact.levels, command.value);
  }
}

void World::tell_holding_point(const Command& command) noexcept {
  const HoldingPointDesc& desc = *desc_.holding_point;
  if (command.kind == Command::Kind::hold_at && std::isfinite(command.value))
    holding_point_->tell(std::clamp(command.value, desc.low, desc.high));
  if (command.kind == Command::Kind::hold_measured && desc_.device.strip)
    holding_point_->measure(command.value > 0);
}

void World::hold(const DeviceSample& sample, std::uint32_t& faults) noexcept {
  if (stiffness_ != stiffness_wanted_ && motion_->stiffen(stiffness_wanted_)) stiffness_ = stiffness_wanted_;
  stiffness_limit_ = 0;
  if (!holding_point_) return;
  strip_ohm_ = sample.strip_ohm;
  holding_point_->update(strip_ohm_);
  const HoldingState state = holding_point_->state();
  const bool known = state == HoldingState::set || state == HoldingState::measured;
  if (!known && static_cast<double>(tick_) * desc_.tick_s >= kFirstReading) faults |= kHoldingPointLost;
  motion_->hold_at(desc_.tool.X_HT.q.conjugate() * (holding_point_->p_HG() - desc_.tool.X_HT.p));
}

World::Touched World::touched(const Pose& X_WT) const noexcept {
  Touched touched;
  if (!holding_point_ || regions().empty()) return touched;
  Vec3 centre_W = Vec3::Zero();
  double all = 0, strongest = -1;
  for (const ContactRegion& region : regions()) {
    const double force = region.force_W.norm();
    all += force;
    centre_W += force * region.p_W;
    if (force <= strongest) continue;
    strongest = force;
    touched.nhat_H = region.nhat_W;
  }
  if (!(all > 0)) return touched;
  const Pose X_HW = desc_.tool.X_HT * X_WT.inverse();
  touched.any = true;
  touched.p_HC = X_HW * Vec3(centre_W / all);
  touched.nhat_H = X_HW.q * touched.nhat_H;
  return touched;
}

Vec3 World::p_HG_D() const noexcept {
  if (!holding_point_) return Vec3::Zero();
  return X_DH_good_.q * holding_point_->p_HG() / desc_.mapping.position_scale;
}

Wrench World::make_up_for_inertia(const Touched& touched, const Vec3& rendered_D) noexcept {
  if (!inertia_compensation_) return {};
  InertiaCompensation::Tick tick{.p_DH = X_DH_good_.p,
                                 .force_D = rendered_D,
                                 .p_HG_D = p_HG_D(),
                                 .between = false,
                                 .open = guard_.gain() >= 1 && !guard_.stopped() && !clutched_};
  if (touched.any && desc_.device.renders_torque) {
    const double place = holding_point_->place();
    const double along = touched.p_HC.dot(desc_.holding_point->axis_H);
    tick.between = along >= std::min(0.0, place) && along <= std::max(0.0, place);
  }
  return inertia_compensation_->process(tick);
}

}  // namespace fulcrum
