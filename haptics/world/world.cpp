#include "haptics/world/world.h"

#include <algorithm>
#include <utility>

#include "haptics/motion/build_motion.h"

namespace fulcrum {
namespace {

std::optional<StiffnessLevels> build_levels(const ContactDesc& contact) {
  if (contact.levels.empty()) return std::nullopt;
  return StiffnessLevels(contact);
}

std::optional<ImpactDetector> build_impact_detector(const SceneDesc& desc) {
  if (!detects_impacts(desc)) return std::nullopt;
  return ImpactDetector(desc.impact, desc.contact.region_radius, desc.scene_field, desc.scene_objects);
}

// -0 + 0 is 0, and digests compare bits: only what is there is added.
void add(Wrench& sum, const Wrench& F) noexcept {
  if (!F.force.isZero(0)) sum.force += F.force;
  if (!F.torque.isZero(0)) sum.torque += F.torque;
}

}  // namespace

World::World(SceneDesc desc)
    : desc_(std::move(desc)),
      input_(desc_, pushes_while_clutched(desc_, desc_)),
      motion_(build_motion(desc_)),
      stiffness_(build_levels(desc_.contact)),
      impacts_(build_impact_detector(desc_)),
      effects_(build_effects(desc_, desc_)),
      listed_(effects_.size()),
      output_(desc_) {}

StepResult step(World& w, const DeviceSample& sample, std::span<const Command> commands) noexcept {
  EffectTick t;
  // Read and estimate.
  std::uint32_t faults = w.output_.watch(sample, commands);
  w.apply(commands);
  t.tick = w.tick_++;
  t.handle = w.input_.follow(sample, faults);

  // Query, solve and couple; events.
  const Wrench coupling_F_H_W = w.answer(t, faults);
  w.output_.stop(faults);
  w.find_impacts(t);

  // What the hand should feel continuously, and what the device itself does to it.
  t.stopped = w.output_.stopped();
  t.gain = w.output_.gain();
  t.wanted_F_H_D = w.output_.in_device(t.handle.engaged ? coupling_F_H_W : Wrench{});
  t.wished_D = w.output_.unlimited().force;
  for (const auto& effect : w.effects_) add(t.wanted_F_H_D, effect->shape(t));
  t.wanted_F_H_D += w.output_.resist(t.handle.per_tick_D, faults);
  Wrench correction_F_H_D;
  for (const auto& effect : w.effects_) add(correction_F_H_D, effect->correct(t));
  t.felt_D = w.output_.render(t.wanted_F_H_D, correction_F_H_D, t.handle, faults);

  // What is sudden.
  for (const auto& effect : w.effects_)
    if (const std::optional<Transient> wanted = effect->strike(t)) w.output_.want(*wanted);
  w.output_.render_transients(t.handle.moved_D, faults);

  // What became of it.
  const Settled settled = w.settle(t, faults);
  w.output_.book(t.handle.moved_D, settled.correction_F_H_D, w.stores(t, settled.stored), faults);
  return w.leave(t, faults);
}

void World::apply(std::span<const Command> commands) noexcept {
  for (const Command& command : commands) {
    for (const auto& effect : effects_) effect->apply(command);
    input_.apply(command);
    if (stiffness_) stiffness_->apply(command);
  }
}

Wrench World::answer(EffectTick& tick, std::uint32_t& faults) noexcept {
  if (stiffness_) stiffness_->set(*motion_);
  if (desc_.holding_point) motion_->hold_at(tick.handle.p_TG);
  tick.answer = motion_->advance(tick.handle.X_WG, tick.handle.V_WG, faults);
  tick.regions = motion_->regions();
  const Pose& X_HT = desc_.tool.X_HT;
  const Vec3 p_TH_W = -(tick.answer.X_WT.q * (X_HT.q.conjugate() * X_HT.p));
  tick.p_WH = tick.answer.X_WT.p + p_TH_W;
  return (-tick.answer.coupling_F_T_W).moved_by(p_TH_W);
}

void World::find_impacts(EffectTick& tick) noexcept {
  if (impacts_) {
    impacts_->process({.X_WT = tick.answer.X_WT,
                       .X_WG = tick.handle.X_WG,
                       .V_WG = tick.handle.V_WG,
                       .touching = motion_->touching()});
    tick.impacts = impacts_->impacts();
  }
  input_.leave_free(tick.regions.empty());
  if (desc_.holding_point && !tick.regions.empty()) {
    tick.touched = contact_centroid(tick.regions, desc_.tool.X_HT * tick.answer.X_WT.inverse());
    input_.touch(tick.touched);
  }
}

Settled World::settle(const EffectTick& tick, std::uint32_t& faults) noexcept {
  Settled all;
  for (std::size_t i = 0; i < effects_.size(); ++i) {
    const Settled settled = effects_[i]->settle(tick, output_.rendered());
    if (i < listed_) {
      add(all.correction_F_H_D, settled.correction_F_H_D);
      all.stored += settled.stored;
    }
    if (settled.torque_limit) motion_->limit_torque(*settled.torque_limit);
    faults |= settled.faults;
  }
  return all;
}

HandleOutput::Stores World::stores(const EffectTick& tick, double of_effects) const noexcept {
  HandleOutput::Stores stores{
      .height = tick.answer.X_WT.p.y(), .springs = motion_->stored_energy(), .effects = of_effects};
  // What drift has lifted the hand has not: it gets none of that weight back.
  if (desc_.mapping.drift > 0) stores.height -= tick.handle.drifted_W.y();
  return stores;
}

void World::record_parts(TickRecord& record) const noexcept {
  for (const auto& effect : effects_) effect->record(record);
  record.holding = input_.holding();
  record.drifted_W = input_.drifted_W();
  if (desc_.device.sample_rate_Hz > 0) record.sample_age = 0;
  if (impacts_) record.impact.emplace();
  if (stiffness_) {
    record.contact_stiffness = stiffness_->now();
    record.contact_stiffness_wanted = stiffness_->wanted();
  }
}

TickRecord World::blank_record() const {
  TickRecord record;
  record_parts(record);
  return record;
}

StepResult World::leave(const EffectTick& tick, std::uint32_t faults) noexcept {
  StepResult result;
  TickRecord& record = result.record;
  for (const auto& effect : effects_)
    effect->command(tick, output_.gain(), output_.stopped(), result.command);
  record_parts(record);
  if (record.drifted_W) result.command.cues.drifted_W = *record.drifted_W;
  output_.leave(result.command, record);
  record.tick = tick.tick;
  record.X_WH = tick.handle.X_WH;
  record.X_WT = motion_->tool().X_WT;
  record.V_WT = motion_->tool().V_WT;
  record.coupling_F_T_W = tick.answer.coupling_F_T_W;
  record.contact_F_T_W = tick.answer.contact_F_T_W;
  record.regions = static_cast<std::int32_t>(tick.regions.size());
  record.depth_max = motion_->depth_max();
  record.faults = faults;
  record.clutched = !tick.handle.engaged;
  if (record.sample_age) record.sample_age = tick.handle.sample_age;
  if (record.impact) {
    record.impact->count = static_cast<std::int32_t>(tick.impacts.size());
    for (const Impact& each : tick.impacts)
      if (each.speed > record.impact->hardest.speed) record.impact->hardest = each;
  }
  return result;
}

}  // namespace fulcrum
