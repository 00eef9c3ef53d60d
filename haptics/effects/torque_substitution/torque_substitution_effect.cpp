#include "haptics/effects/torque_substitution/torque_substitution_effect.h"

#include "haptics/effects/effects.h"
#include "haptics/math/number_text.h"
#include "haptics/signal/held_sine.h"

namespace fulcrum {
namespace {

// Slower, and its half waves would push the hand to and fro (safety/transient_budget.h).
constexpr double kSlowest_Hz = 80;

TorqueSurroundings torque_surroundings(const PlainScene& scene) {
  return {
      .tick_s = scene.tick_s,
      .tool_reach = tool_radius(scene),
      .max_force = scene.coupling.max_force,
      .max_torque = scene.coupling.max_torque,
      .renders_force = scene.device.renders_force,
      .senses_rotation = scene.device.senses_rotation,
      .springs = coupled(scene.contact.response) && scene.contact.response != ContactResponse::constraint};
}

}  // namespace

std::string TorqueSubstitutionEffect::why_not(const Desc& /*desc*/, const PlainScene& scene) {
  return scene.device.renders_torque ? "the device '" + scene.device.name + "' renders torque" : "";
}

void TorqueSubstitutionEffect::check(FigureCheck& figures, const Desc& torque) {
  const auto& [variant, bad_above, tool_radius, limit_stiffness, vibration_gain, amplitude, frequency_Hz,
               reference, ghost_gain, ghost_above, ghost_below, ghost_fade] = torque;
  const std::string name = "torque_substitution";
  if (bad_above) figures.above(name + ".bad_above", *bad_above);
  if (tool_radius) figures.above(name + ".tool_radius", *tool_radius);
  figures.from_to(name + ".vibration.gain", vibration_gain, 0, 1);
  figures.at_least(name + ".vibration.amplitude", amplitude);
  figures.above(name + ".vibration.frequency_Hz", frequency_Hz);
  if (reference) figures.above(name + ".vibration.reference", *reference);
  figures.from_to(name + ".ghost.gain", ghost_gain, 0, 1);
  if (ghost_above) figures.above(name + ".ghost.above", *ghost_above);
  if (ghost_below) figures.above(name + ".ghost.below", *ghost_below);
  figures.above_to(name + ".ghost.fade", ghost_fade, 0, FigureCheck::kLongestTime);
}

std::optional<Error> TorqueSubstitutionEffect::refuse(const Desc& desc, const PlainScene& scene) {
  const TorqueThresholds thresholds = torque_thresholds(desc, scene.coupling.max_torque);
  if (!(thresholds.ghost_below < thresholds.ghost_above))
    return Error{"In torque_substitution the ghost leaves below " + number_text(thresholds.ghost_below) +
                 " N m and appears above " + number_text(thresholds.ghost_above) +
                 " N m: lower ghost.below, or raise ghost.above (without it twice bad_above)."};
  const double fastest_Hz = 1 / (kMinSamplesPerPeriod * scene.tick_s);
  if (!(desc.frequency_Hz >= kSlowest_Hz && desc.frequency_Hz <= fastest_Hz))
    return Error{"torque_substitution.vibration.frequency_Hz is " + number_text(desc.frequency_Hz) +
                 "; at this tick rate it must be from " + number_text(kSlowest_Hz) + " to " +
                 number_text(fastest_Hz) + ": change it, or raise tick_rate_Hz."};
  if (scene.holding_point && moves_grip(scene.contact.response) && why_not(desc, scene).empty() &&
      desc.limit_stiffness)
    return Error{
        "torque_substitution softens a coupling about the tool's centre of mass, and under this response a "
        "holding_point takes its spring to where the hand holds: set torque_substitution.limit_stiffness to "
        "false, leave one of the two out, or name another response."};
  return std::nullopt;
}

std::vector<LeftOut> TorqueSubstitutionEffect::left_out(const Desc& desc, const PlainScene& scene) {
  const std::string device = "the device '" + scene.device.name + "' ";
  std::vector<LeftOut> parts;
  if (!scene.device.renders_force) parts.push_back({"vibration", device + "has no motors"});
  if (!scene.device.senses_rotation) parts.push_back({"ghost", device + "senses no rotation"});
  if (!desc.limit_stiffness)
    parts.push_back({"stiffness limit", "torque_substitution.limit_stiffness is off"});
  else if (!coupled(scene.contact.response))
    parts.push_back({"stiffness limit", "the response direct has no coupling"});
  else if (scene.contact.response == ContactResponse::constraint)
    parts.push_back(
        {"stiffness limit", "under the response constraint the tool stays out whatever the torque"});
  return parts;
}

std::vector<TransientSource> TorqueSubstitutionEffect::transients(const Desc& /*desc*/,
                                                                  const PlainScene& scene) {
  if (!scene.device.renders_force) return {};
  return {TransientSource::torque_substitution};
}

std::vector<Knob> TorqueSubstitutionEffect::knobs(const Desc& desc, const PlainScene& scene,
                                                  const EffectRecords& records) {
  const TorqueRecord record = records.torque_substitution.value_or(TorqueRecord());
  std::vector<Knob> knobs;
  if (scene.device.renders_force)
    knobs.push_back({.kind = Command::Kind::vibration_gain,
                     .name = "Vibration",
                     .key = 'V',
                     .gain = record.vibration_gain,
                     .on = desc.vibration_gain > 0 ? desc.vibration_gain : 1,
                     .level = desc.amplitude > 0 ? record.vibration / desc.amplitude : 0});
  if (scene.device.senses_rotation)
    knobs.push_back({.kind = Command::Kind::ghost_gain,
                     .name = "Ghost",
                     .key = 'G',
                     .gain = record.ghost_gain,
                     .on = desc.ghost_gain > 0 ? desc.ghost_gain : 1,
                     .level = record.ghost});
  return knobs;
}

std::optional<TorqueNote> TorqueSubstitutionEffect::torque_note(const Desc& /*desc*/, const PlainScene& scene,
                                                                const EffectRecords& records) {
  if (!scene.device.renders_force && !scene.device.senses_rotation) return std::nullopt;
  const TorqueRecord record = records.torque_substitution.value_or(TorqueRecord());
  const bool vibration = record.vibration_gain > 0, ghost = record.ghost_gain > 0;
  const char* const with_ghost = vibration ? "variant C" : "";
  return TorqueNote{record.bad, ghost ? with_ghost : vibration ? "variant B" : "variant A"};
}

TorqueSubstitutionEffect::TorqueSubstitutionEffect(const Desc& desc, const PlainScene& scene)
    : effect_(desc, torque_surroundings(scene)),
      tool_weight_(tool_weight(scene.tool)),
      q_DW_(scene.mapping.X_WD.q.conjugate()) {}

std::optional<Transient> TorqueSubstitutionEffect::strike(const EffectTick& tick) noexcept {
  const ToolAnswer& answer = tick.answer;
  TorqueSubstitution::Tick torque;
  torque.contact_torque = answer.contact_F_T_W.torque;
  torque.coupling_F_T_W = {answer.coupling_F_T_W.force, answer.full_torque_T_W};
  torque.coupling_F_T_W.force.y() -= tool_weight_;
  torque.torque = answer.coupling_F_T_W.torque.norm();
  torque.angle = answer.turn_W.norm();
  torque.regions = tick.regions;
  torque.felt_D = tick.felt_D;
  torque.engaged = tick.handle.engaged;
  const TorqueSubstitution::Demand demand = effect_.process(torque);
  torque_limit_ = demand.torque_limit;
  return Transient{TransientSource::torque_substitution, {demand.vibration_D, Vec3::Zero()}};
}

Settled TorqueSubstitutionEffect::settle(const EffectTick& /*tick*/, const Rendered& rendered) noexcept {
  energy_ = rendered.of(TransientSource::torque_substitution).energy;
  return {.correction_F_H_D = {}, .torque_limit = torque_limit_};
}

void TorqueSubstitutionEffect::command(const EffectTick& tick, double /*gain*/, bool /*stopped*/,
                                       DeviceCommand& command) noexcept {
  const TorqueRecord& record = effect_.record();
  command.cues = {record.vibration, record.ghost, q_DW_ * -tick.answer.turn_W};
}

void TorqueSubstitutionEffect::record(EffectRecords& records) const noexcept {
  records.torque_substitution.emplace(effect_.record()).energy = energy_;
}

BuiltPart TorqueSubstitutionEffect::part() const {
  std::string what = "bad above " + number_text(effect_.bounds().torque) + " N m and a lever of " +
                     number_text(effect_.bounds().radius * 1e3) + " mm";
  if (effect_.limits()) what += "; limits the coupling's torque";
  if (effect_.vibrates()) what += "; vibration";
  if (effect_.shows_ghost())
    what += "; ghost from " + number_text(effect_.ghost_above()) + " to " +
            number_text(effect_.ghost_below()) + " N m";
  return {kName, what, sizeof(TorqueSubstitution)};
}

}  // namespace fulcrum
