#include "haptics/effects/torque_substitution/torque_substitution.h"

#include <algorithm>

namespace fulcrum {
namespace {

constexpr double kContact = 0.1;  // of T_min: eps
constexpr double kMin = 0.1;      // of T_min: to which a limit falls at most

TorqueBounds bounds_of(const TorqueSubstitutionDesc& desc, const TorqueSurroundings& around) {
  const double torque = torque_thresholds(desc, around.max_torque).bad;
  return {torque, desc.tool_radius.value_or(around.tool_reach), kContact * torque};
}

}  // namespace

TorqueSubstitution::TorqueSubstitution(const TorqueSubstitutionDesc& desc, const TorqueSurroundings& around)
    : bounds_(bounds_of(desc, around)),
      classifier_(bounds_, around.tick_s),
      shows_ghost_(around.senses_rotation),
      ghost_above_(torque_thresholds(desc, around.max_torque).ghost_above),
      ghost_below_(torque_thresholds(desc, around.max_torque).ghost_below),
      ghost_(desc.ghost_fade, around.tick_s) {
  if (desc.limit_stiffness && around.springs) limit_.emplace(around.max_force, kMin * bounds_.torque);
  if (around.renders_force)
    vibration_.emplace(VibrationDesc{.amplitude = desc.amplitude,
                                     .frequency_Hz = desc.frequency_Hz,
                                     .reference = desc.reference.value_or(bounds_.torque),
                                     .largest = around.max_torque},
                       around.tick_s);
  if (vibrates() && desc.variant != TorqueVariant::A) record_.vibration_gain = desc.vibration_gain;
  if (shows_ghost_ && desc.variant == TorqueVariant::C) record_.ghost_gain = desc.ghost_gain;
}

TorqueSubstitution::Demand TorqueSubstitution::process(const Tick& tick) noexcept {
  Demand demand;
  record_.magnitude = tick.coupling_F_T_W.torque.norm();
  record_.stiffness = tick.angle > 0 ? tick.torque / tick.angle : 0.0;
  record_.bad = classifier_.update(tick.contact_torque, tick.coupling_F_T_W);
  if (limit_)
    demand.torque_limit =
        limit_->update(record_.bad, record_.magnitude, tick.contact_torque.norm(), tick.regions);
  if (vibration_) {
    const double level =
        record_.bad && tick.engaged ? record_.vibration_gain * vibration_->strength(record_.magnitude) : 0.0;
    demand.vibration_D = vibration_->process(level, tick.felt_D);
    record_.vibration = vibration_->amplitude();
  }
  ghost_wanted_ = record_.magnitude > (ghost_wanted_ ? ghost_below_ : ghost_above_);
  record_.ghost = ghost_.towards(ghost_wanted_ ? record_.ghost_gain : 0.0);
  return demand;
}

void TorqueSubstitution::apply(const Command& command) noexcept {
  const double gain = command.gain();
  if (command.kind == Command::Kind::vibration_gain && vibrates()) record_.vibration_gain = gain;
  if (command.kind == Command::Kind::ghost_gain && shows_ghost_) record_.ghost_gain = gain;
}

}  // namespace fulcrum
