#include "haptics/effects/impact_vibration/impact_vibration_effect.h"

#include <algorithm>

#include "haptics/effects/effects.h"
#include "haptics/math/number_text.h"

namespace fulcrum {
namespace {

ImpactSurroundings impact_surroundings(const PlainScene& scene) {
  const DeviceDesc& device = scene.device;
  const double peak = figures_of(TransientSource::impact_vibration).peak;
  return {.tick_s = scene.tick_s,
          .reach = tool_reach(scene, scene.tool.X_HT.inverse().p),
          .mapping = scene.mapping,
          .largest_force = device.renders_force ? peak * device.max_force : 0.0,
          .largest_torque = device.renders_torque ? peak * device.max_torque : 0.0,
          .highest_Hz = highest_vibration(device.bandwidth_Hz, scene.tick_s)};
}

}  // namespace

std::string ImpactVibrationEffect::why_not(const Desc& /*desc*/, const PlainScene& scene) {
  const bool motors = scene.device.renders_force || scene.device.renders_torque;
  return motors ? "" : "the device '" + scene.device.name + "' has no motors";
}

void ImpactVibrationEffect::check(FigureCheck& figures, const Desc& vibration) {
  const auto& [render, distance, gain, voices, hand_stiffness, materials] = vibration;
  figures.from_to("impact_vibration.gain", gain, 0, 1);
  figures.from_to("impact_vibration.voices", static_cast<double>(voices), 1,
                  static_cast<double>(ImpactVoices::kMax));
  figures.above("impact_vibration.hand_stiffness", hand_stiffness);
  for (const ImpactMaterial& material : materials) {
    const auto& [title, attack, decay, frequency_Hz] = material;
    const std::string name = "of the material '" + title + "' ";
    figures.at_least(name + "attack", attack);
    figures.above(name + "decay", decay);
    figures.above(name + "frequency_Hz", frequency_Hz);
  }
}

std::optional<Error> ImpactVibrationEffect::refuse(const Desc& desc, const PlainScene& /*scene*/) {
  if (desc.materials.empty()) return Error{"impact_vibration needs a material for what is struck."};
  return std::nullopt;
}

std::vector<LeftOut> ImpactVibrationEffect::left_out(const Desc& desc, const PlainScene& scene) {
  const DeviceDesc& device = scene.device;
  std::vector<LeftOut> parts;
  if (!device.renders_torque)
    parts.push_back({"vibration about an axis", "the device '" + device.name + "' renders no torque: " +
                                                    (desc.render == ImpactRender::torque
                                                         ? "only impacts along the lever are felt, as a force"
                                                         : "impacts are felt as a force")});
  if (!device.renders_force)
    parts.push_back({"vibration along a normal", "the device '" + device.name + "' renders no force"});
  // Beside the hand a sinusoid is highest, and a beam's modes are the same everywhere.
  const double highest = highest_vibration(device.bandwidth_Hz, scene.tick_s);
  for (const ImpactMaterial& material : desc.materials) {
    const VibrationModes modes = vibration_modes(desc.distance, material.frequency_Hz, 0, 1);
    for (std::size_t n = 0; n < modes.count; ++n) {
      if (modes.modes[n].frequency_Hz <= highest) continue;
      parts.push_back({"a mode of " + material.name, number_text(modes.modes[n].frequency_Hz) +
                                                         " Hz, and device and tick rate render up to " +
                                                         number_text(highest) + " Hz"});
    }
  }
  return parts;
}

std::vector<TransientSource> ImpactVibrationEffect::transients(const Desc& /*desc*/,
                                                               const PlainScene& /*scene*/) {
  return {TransientSource::impact_vibration};
}

std::vector<Knob> ImpactVibrationEffect::knobs(const Desc& desc, const PlainScene& scene,
                                               const EffectRecords& records) {
  const ImpactVibrationRecord record = records.impact_vibration.value_or(ImpactVibrationRecord());
  const double peak = figures_of(TransientSource::impact_vibration).peak;
  const auto part = [peak](const Vec3& v, double largest) {  // of what one voice may have at its strongest
    return largest > 0 ? v.norm() / (0.5 * peak * largest) : 0.0;
  };
  return {{.kind = Command::Kind::impact_gain,
           .name = "Vibration",
           .key = 'I',
           .gain = record.gain,
           .on = desc.gain > 0 ? desc.gain : 1,
           .level = std::min(1.0, std::max(part(record.F_H_D.force, scene.device.max_force),
                                           part(record.F_H_D.torque, scene.device.max_torque)))}};
}

ImpactVibrationEffect::ImpactVibrationEffect(const Desc& desc, const PlainScene& scene)
    : desc_(desc), effect_(desc, impact_surroundings(scene)) {}

std::optional<Transient> ImpactVibrationEffect::strike(const EffectTick& tick) noexcept {
  const bool engaged = tick.handle.engaged && !tick.stopped;
  return Transient{TransientSource::impact_vibration, effect_.process(tick.impacts, tick.p_WH, engaged)};
}

Settled ImpactVibrationEffect::settle(const EffectTick& /*tick*/, const Rendered& rendered) noexcept {
  rendered_ = rendered.of(TransientSource::impact_vibration);
  return {};
}

void ImpactVibrationEffect::record(EffectRecords& records) const noexcept {
  ImpactVibrationRecord& record = records.impact_vibration.emplace(effect_.record());
  record.F_H_D = rendered_.F_H_D;
  record.energy = rendered_.energy;
}

BuiltPart ImpactVibrationEffect::part() const {
  const ImpactSurroundings& around = effect_.around();
  std::string what = desc_.render == ImpactRender::wrench ? "wrench" : "torque";
  what += desc_.distance == DistanceModel::beam ? ", a beam" : ", a sinusoid";
  what += " of " + number_text(around.reach * 1e3) + " mm, at most " + std::to_string(desc_.voices) +
          " voices, up to " + number_text(around.highest_Hz) + " Hz;";
  for (std::size_t i = 0; i < desc_.materials.size(); ++i)
    what += (i == 0 ? " " : ", ") + desc_.materials[i].name + " " +
            number_text(desc_.materials[i].frequency_Hz) + " Hz";
  return {kName, what, sizeof(ImpactVibration)};
}

}  // namespace fulcrum
