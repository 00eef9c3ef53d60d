#pragma once
// Impact vibration in a tick: impact_vibration.h on a scene.

#include <optional>
#include <vector>

#include "haptics/effects/effect.h"
#include "haptics/effects/impact_vibration/impact_vibration.h"
#include "haptics/math/result.h"
#include "haptics/scene/channel_use.h"
#include "haptics/scene/figure_check.h"
#include "haptics/scene/plain_scene.h"

namespace fulcrum {

class ImpactVibrationEffect final : public Effect {
public:
  using Desc = ImpactVibrationDesc;
  static constexpr const char* kName = "impact vibration";

  static std::string why_not(const Desc& desc, const PlainScene& scene);
  static void check(FigureCheck& figures, const Desc& desc);
  static std::optional<Error> refuse(const Desc& desc, const PlainScene& scene);
  static std::vector<LeftOut> left_out(const Desc& desc, const PlainScene& scene);
  static std::vector<TransientSource> transients(const Desc& desc, const PlainScene& scene);
  static std::optional<ChannelUse> channel_use(const Desc&, const PlainScene&) { return std::nullopt; }
  static std::optional<std::string> advise(const Desc&, const PlainScene&) { return std::nullopt; }
  static std::vector<Knob> knobs(const Desc& desc, const PlainScene& scene, const EffectRecords& records);
  static std::optional<TorqueNote> torque_note(const Desc&, const PlainScene&, const EffectRecords&) {
    return std::nullopt;
  }
  static constexpr bool kAsksForImpacts = true;
  static constexpr bool kPushesWhileClutched = false;
  static constexpr bool kShowsGhost = false;
  static constexpr bool kTellsObjectsApart = true;

  ImpactVibrationEffect(const Desc& desc, const PlainScene& scene);

  void apply(const Command& command) noexcept override { effect_.apply(command); }
  std::optional<Transient> strike(const EffectTick& tick) noexcept override;
  Settled settle(const EffectTick& tick, const Rendered& rendered) noexcept override;
  void record(EffectRecords& records) const noexcept override;
  BuiltPart part() const override;

private:
  Desc desc_;
  ImpactVibration effect_;
  Rendered::Source rendered_;
};

}  // namespace fulcrum
