// What a World's effects do in a tick: what they want, what the motors give of it, what they leave behind.

#include <algorithm>

#include "haptics/world/world.h"

namespace fulcrum {

// Answers the vibration on the handle (3) N, in D.
Vec3 World::substitute_torque(const ToolAnswer& answer, const Vec3& felt_D) noexcept {
  if (!torque_substitution_) return Vec3::Zero();
  TorqueSubstitution::Tick tick;
  tick.contact_torque = answer.contact_F_T_W.torque;
  tick.coupling_F_T_W = {answer.coupling_F_T_W.force, answer.full_torque_T_W};
  tick.coupling_F_T_W.force.y() -= tool_weight(desc_.tool);
  tick.torque = answer.coupling_F_T_W.torque.norm();
  tick.angle = answer.turn_W.norm();
  tick.regions = regions();
  tick.felt_D = felt_D;
  tick.engaged = !clutched_;
  const TorqueSubstitution::Demand demand = torque_substitution_->process(tick);
  motion_->limit_torque(demand.torque_limit);
  return demand.vibration_D;
}

void World::demand_transients(const ToolAnswer& answer, const Wanted& wanted, const Vec3& felt_D,
                              const Vec3& p_WH) noexcept {
  const auto of = [this](TransientSource source) -> Wrench& {
    return transients_[static_cast<std::size_t>(source)];
  };
  const bool engaged = !clutched_ && !guard_.stopped();
  of(TransientSource::torque_substitution) = {substitute_torque(answer, felt_D), Vec3::Zero()};
  if (impact_vibration_)
    of(TransientSource::impact_vibration) = impact_vibration_->process(impacts(), p_WH, engaged);
  if (!braking_pulse_) return;
  pulse_ = braking_pulse_->process({.impacts = impacts(),
                                    .p_WH = p_WH,
                                    .q_WH = answer.X_WT.q * desc_.tool.X_HT.q.conjugate(),
                                    .X_WG = wanted.X_WG,
                                    .V_WG = wanted.V_WG,
                                    .engaged = engaged});
  of(TransientSource::braking_pulse) = pulse_.F_H_D;
}

// What is cut changes no faster than the slew limit either. It begins at what the motors can hold here of the
// last tick's: where that is less, because the handle has come to where they are weaker, the force falls at
// once.
Allocation World::allocate_continuous(const Wrench& limited_F_H_D, std::uint32_t& faults) noexcept {
  Allocation wanted = motors_.wrench(limited_F_H_D);
  if (wanted.clamped() && holding_point_)  // what is cut keeps its direction where the hand feels it
    wanted = motors_.wrench(limited_F_H_D, p_HG_D());
  if (wanted.F_H_D.force == limited_F_H_D.force && wanted.F_H_D.torque == limited_F_H_D.torque) return wanted;
  faults |= kMotorClamped;
  const Allocation held = motors_.whole(guard_.last());
  const double part = guard_.slew_part(held.F_H_D, wanted.F_H_D);
  if (part == 1) return wanted;
  faults |= kSlewLimited;
  return motors_.between(held, wanted, part);
}

// A pulse asks for far more than there is. What the motors can do of it is found first, and then bounded.
Allocation World::allocate_pulse(const Wrench& commanded_F_H_D, const Vec6& moved_D,
                                 std::uint32_t& faults) noexcept {
  const Allocation able =
      pulse_.moment ? motors_.pulse(pulse_.F_H_D, pulse_.p_HG_D, pulse_.lever) : motors_.whole(pulse_.F_H_D);
  const Wrench allowed =
      guard_.limit_transient(TransientSource::braking_pulse, able.F_H_D, commanded_F_H_D, moved_D, faults);
  Allocation allocation = able;
  if (allowed.force != able.F_H_D.force || allowed.torque != able.F_H_D.torque) {
    const auto share = [](const Vec3& of, const Vec3& whole) {
      const double size = whole.norm();
      return size > 0 ? std::min(1.0, of.norm() / size) : 0.0;
    };
    const auto felt = [this](const Wrench& F_H_D) {
      return Vec3(pulse_.p_HG_D.cross(F_H_D.force) - F_H_D.torque);
    };
    allocation = motors_.whole(allowed);
    allocation.force_share = share(allocation.F_H_D.force, pulse_.F_H_D.force);
    allocation.moment_share = share(felt(allocation.F_H_D), felt(pulse_.F_H_D));
  }
  pulse_shares_ = {allocation.force_share, allocation.moment_share};
  return allocation;
}

// Each transient in turn, with the motors that those before it left. Adds what they do to the command.
void World::render_transients(const Vec6& moved_D, Wrench& commanded_F_H_D, std::uint32_t& faults) noexcept {
  for (std::size_t i = 0; i < kTransientSources; ++i) {
    const TransientSource source{i};
    if (guard_.budget(source) == nullptr) continue;
    const Wrench wanted_F_H_D = transients_[i];
    Wrench& F_H_D = transients_[i];
    if (source == TransientSource::braking_pulse && !wanted_F_H_D.is_zero()) {
      const Allocation allocation = allocate_pulse(commanded_F_H_D, moved_D, faults);
      motors_.take(allocation);
      F_H_D = allocation.F_H_D;
      if (allocation.clamped()) faults |= kMotorClamped;
    } else {
      F_H_D = guard_.limit_transient(source, wanted_F_H_D, commanded_F_H_D, moved_D, faults);
      if (!F_H_D.is_zero()) {
        const Allocation allocation = motors_.whole(F_H_D);
        motors_.take(allocation);
        F_H_D = allocation.F_H_D;
        if (allocation.clamped()) faults |= kMotorClamped;
      }
    }
    guard_.commanded(source, F_H_D);
    missing_.force += wanted_F_H_D.force - F_H_D.force;
    missing_.torque += wanted_F_H_D.torque - F_H_D.torque;
    if (!F_H_D.force.isZero(0)) commanded_F_H_D.force += F_H_D.force;  // or -0 would become 0
    if (!F_H_D.torque.isZero(0)) commanded_F_H_D.torque += F_H_D.torque;
  }
}

Vec3 World::move_vibration(const Wrench& F_H_W, const Vec6& moved_D) noexcept {
  if (!vibrotactile_motion_) return Vec3::Zero();
  Vec6 V_WH;
  V_WH << V_WH_.v, V_WH_.w;
  const Vec3 force_W = vibrotactile_motion_->process({.p_WH = X_WH_.p,
                                                      .v_WH = V_WH_.v,
                                                      .moved = moved_D[0],
                                                      .speed = desc_.mapping.motion_in_device(V_WH)[0],
                                                      .felt = desc_.mapping.wrench_in_device(F_H_W).force.x(),
                                                      .touching = !regions().empty(),
                                                      .engaged = !clutched_,
                                                      .stopped = guard_.stopped()});
  return desc_.device.renders_force ? Vec3(desc_.mapping.X_WD.q.conjugate() * force_W) : Vec3(Vec3::Zero());
}

void World::record_effects(TickRecord& record) const noexcept {
  const auto energy = [this](TransientSource source) {
    const TransientBudget* budget = guard_.budget(source);
    return budget ? budget->energy() : 0.0;
  };
  if (torque_substitution_) {
    record.torque = torque_substitution_->cues();
    record.torque.energy = energy(TransientSource::torque_substitution);
  }
  if (impact_detector_) {
    ImpactTick& impact = record.impact.emplace();
    impact.count = static_cast<std::int32_t>(impacts().size());
    for (const Impact& each : impacts()) {
      if (each.speed > impact.hardest.speed) impact.hardest = each;
    }
  }
  if (braking_pulse_) {
    PulseCues& cues = record.pulse.emplace(braking_pulse_->cues());
    cues.F_H_D = transients_[static_cast<std::size_t>(TransientSource::braking_pulse)];
    if (!cues.wanted_F_H_D.is_zero()) {
      cues.force_share = pulse_shares_.force;
      cues.moment_share = pulse_shares_.moment;
    }
    if (const TransientBudget* budget = guard_.budget(TransientSource::braking_pulse)) {
      cues.energy = budget->force_energy();
      cues.moment_energy = budget->torque_energy();
    }
  }
  if (vibrotactile_motion_) record.vibrotactile = vibrotactile_motion_->cues();
  if (holding_point_) {
    record.holding = {holding_point_->place(), holding_point_->p_HG(), holding_point_->state(), strip_ohm_,
                      stiffness_limit_};
  }
  if (inertia_compensation_) record.inertia = inertia_compensation_->cues();
  if (!desc_.contact.levels.empty()) {
    record.contact_stiffness = stiffness_;
    record.contact_stiffness_wanted = stiffness_wanted_;
  }
  record.missing_F_H_D = missing_;
  if (impact_vibration_) {
    record.impact_vibration = impact_vibration_->cues();
    record.impact_vibration->F_H_D = transients_[static_cast<std::size_t>(TransientSource::impact_vibration)];
    record.impact_vibration->energy = energy(TransientSource::impact_vibration);
  }
}

}  // namespace fulcrum
