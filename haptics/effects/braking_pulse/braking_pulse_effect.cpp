#include "haptics/effects/braking_pulse/braking_pulse_effect.h"

#include "haptics/effects/effects.h"
#include "haptics/math/number_text.h"

namespace fulcrum {

std::string BrakingPulseEffect::why_not(const Desc& /*desc*/, const PlainScene& scene) {
  return scene.device.renders_force ? "" : "the device '" + scene.device.name + "' has no motors";
}

void BrakingPulseEffect::check(FigureCheck& figures, const Desc& pulse) {
  const auto& [hand_mass, ticks, p_HG, moment, gain] = pulse;
  figures.above("braking_pulse.hand_mass", hand_mass);
  figures.from_to("braking_pulse.ticks", ticks, 1, BrakingPulse::kMaxTicks);
  figures.finite("braking_pulse.grasp", p_HG);
  figures.from_to("braking_pulse.gain", gain, 0, 1);
}

std::optional<Error> BrakingPulseEffect::refuse(const Desc& /*desc*/, const PlainScene& /*scene*/) {
  return std::nullopt;
}

std::vector<LeftOut> BrakingPulseEffect::left_out(const Desc& /*desc*/, const PlainScene& scene) {
  if (scene.device.renders_torque) return {};
  return {{"moment of the pulse", "the device '" + scene.device.name + "' renders no torque"}};
}

std::vector<TransientSource> BrakingPulseEffect::transients(const Desc& /*desc*/,
                                                            const PlainScene& /*scene*/) {
  return {TransientSource::braking_pulse};
}

std::vector<Knob> BrakingPulseEffect::knobs(const Desc& desc, const PlainScene& scene,
                                            const EffectRecords& records) {
  const PulseRecord record = records.braking_pulse.value_or(PulseRecord());
  std::vector<Knob> knobs{{.kind = Command::Kind::pulse_gain,
                           .name = "Pulse",
                           .key = 'B',
                           .gain = record.gain,
                           .on = desc.gain > 0 ? desc.gain : 1,
                           .level = record.force_share,
                           .brief = true}};
  if (scene.device.renders_torque)
    knobs.push_back({.kind = Command::Kind::pulse_moment,
                     .name = "Moment",
                     .key = 'M',
                     .gain = record.moment ? 1.0 : 0.0,
                     .level = record.moment_share,
                     .brief = true});
  return knobs;
}

BrakingPulseEffect::BrakingPulseEffect(const Desc& desc, const PlainScene& scene)
    : effect_(desc, scene.mapping, scene.tick_s),
      q_TH_(scene.tool.X_HT.q.conjugate()),
      renders_torque_(scene.device.renders_torque) {}

std::optional<Transient> BrakingPulseEffect::strike(const EffectTick& tick) noexcept {
  const BrakingPulse::Demand pulse = effect_.process({.impacts = tick.impacts,
                                                      .p_WH = tick.p_WH,
                                                      .q_WH = tick.answer.X_WT.q * q_TH_,
                                                      .X_WG = tick.handle.X_WG,
                                                      .V_WG = tick.handle.V_WG,
                                                      .engaged = tick.handle.engaged && !tick.stopped});
  return Transient{TransientSource::braking_pulse, pulse.F_H_D,
                   Grasp{pulse.p_HG_D, pulse.lever, pulse.moment}};
}

Settled BrakingPulseEffect::settle(const EffectTick& /*tick*/, const Rendered& rendered) noexcept {
  rendered_ = rendered.of(TransientSource::braking_pulse);
  return {};
}

void BrakingPulseEffect::record(EffectRecords& records) const noexcept {
  PulseRecord& record = records.braking_pulse.emplace(effect_.record());
  record.F_H_D = rendered_.F_H_D;
  if (!record.wanted_F_H_D.is_zero()) {
    record.force_share = rendered_.force_share;
    record.moment_share = rendered_.moment_share;
  }
  record.energy = rendered_.force_energy;
  record.moment_energy = rendered_.torque_energy;
}

BuiltPart BrakingPulseEffect::part() const {
  const BrakingPulseDesc& pulse = effect_.desc();
  std::string what = "stops a hand of " + number_text(pulse.hand_mass) + " kg in " +
                     std::to_string(pulse.ticks) + (pulse.ticks == 1 ? " tick" : " ticks");
  if (renders_torque_)
    what += "; a moment makes up for missing force at " + number_text(pulse.p_HG.norm() * 1e3) +
            " mm from the handle's origin";
  return {kName, what, sizeof(BrakingPulse)};
}

}  // namespace fulcrum
