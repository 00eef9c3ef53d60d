#include "haptics/effects/texture/texture_effect.h"

#include <algorithm>

#include "haptics/effects/effects.h"
#include "haptics/math/number_text.h"

namespace fulcrum {

std::string TextureEffect::why_not(const Desc& /*desc*/, const PlainScene& scene) {
  return scene.device.renders_force ? "" : "the device '" + scene.device.name + "' has no motors";
}

void TextureEffect::check(FigureCheck& figures, const Desc& texture) {
  const auto& [wavelength, height, direction_W, gain] = texture;
  figures.above_to("texture.wavelength", wavelength, 0, 1);
  figures.from_to("texture.height", height, 0, 1);
  figures.direction("texture.direction", direction_W);
  figures.from_to("texture.gain", gain, 0, 1);
}

std::vector<Knob> TextureEffect::knobs(const Desc& desc, const PlainScene& scene,
                                       const EffectRecords& records) {
  const TextureRecord record = records.texture.value_or(TextureRecord());
  const double largest = scene.device.max_force;
  return {{.kind = Command::Kind::texture_gain,
           .name = "Ridges",
           .key = 'X',
           .gain = record.gain,
           .on = desc.gain > 0 ? desc.gain : 1,
           .level = largest > 0 ? std::min(1.0, record.force_W.norm() / largest) : 0}};
}

TextureEffect::TextureEffect(const Desc& desc, const PlainScene& scene)
    : effect_(desc, scene.tick_s), mapping_(scene.mapping), renders_torque_(scene.device.renders_torque) {}

Wrench TextureEffect::shape(const EffectTick& tick) noexcept {
  Wrench F_H_D = mapping_.wrench_in_device(effect_.process({.regions = tick.regions,
                                                            .p_WH = tick.p_WH,
                                                            .v_WH = tick.handle.V_WH.v,
                                                            .engaged = tick.handle.engaged}));
  if (!renders_torque_) F_H_D.torque.setZero();
  return F_H_D;
}

void TextureEffect::record(EffectRecords& records) const noexcept {
  records.texture = effect_.record();
}

BuiltPart TextureEffect::part() const {
  const TextureDesc& texture = effect_.desc();
  return {kName,
          "ridges of " + number_text(texture.height * 1e6) + " um every " +
              number_text(texture.wavelength * 1e3) + " mm: up to " + number_text(effect_.steepest()) +
              " of the force that presses, whole up to " + number_text(effect_.fastest()) + " m/s",
          sizeof(Texture)};
}

}  // namespace fulcrum
