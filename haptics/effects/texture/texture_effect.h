#pragma once
// A texture in a tick: texture.h on a scene.

#include <optional>
#include <vector>

#include "haptics/effects/effect.h"
#include "haptics/effects/texture/texture.h"
#include "haptics/math/result.h"
#include "haptics/scene/channel_use.h"
#include "haptics/scene/figure_check.h"
#include "haptics/scene/plain_scene.h"

namespace fulcrum {

class TextureEffect final : public Effect {
public:
  using Desc = TextureDesc;
  static constexpr const char* kName = "texture";

  static std::string why_not(const Desc& desc, const PlainScene& scene);
  static void check(FigureCheck& figures, const Desc& desc);
  static std::optional<Error> refuse(const Desc&, const PlainScene&) { return std::nullopt; }
  static std::vector<LeftOut> left_out(const Desc&, const PlainScene&) { return {}; }
  static std::vector<TransientSource> transients(const Desc&, const PlainScene&) { return {}; }
  static std::optional<ChannelUse> channel_use(const Desc&, const PlainScene&) { return std::nullopt; }
  static std::optional<std::string> advise(const Desc&, const PlainScene&) { return std::nullopt; }
  static std::vector<Knob> knobs(const Desc& desc, const PlainScene& scene, const EffectRecords& records);
  static std::optional<TorqueNote> torque_note(const Desc&, const PlainScene&, const EffectRecords&) {
    return std::nullopt;
  }
  static constexpr bool kAsksForImpacts = false;
  static constexpr bool kPushesWhileClutched = false;
  static constexpr bool kShowsGhost = false;
  static constexpr bool kTellsObjectsApart = false;

  TextureEffect(const Desc& desc, const PlainScene& scene);

  void apply(const Command& command) noexcept override { effect_.apply(command); }
  Wrench shape(const EffectTick& tick) noexcept override;
  void record(EffectRecords& records) const noexcept override;
  BuiltPart part() const override;

private:
  Texture effect_;
  MappingDesc mapping_;
  bool renders_torque_;
};

}  // namespace fulcrum
