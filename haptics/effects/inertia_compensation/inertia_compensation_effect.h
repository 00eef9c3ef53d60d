#pragma once
// Compensation of a device's inertia in a tick: inertia_compensation.h on a scene.

#include <optional>
#include <vector>

#include "haptics/effects/effect.h"
#include "haptics/effects/inertia_compensation/inertia_compensation.h"
#include "haptics/math/result.h"
#include "haptics/scene/channel_use.h"
#include "haptics/scene/figure_check.h"
#include "haptics/scene/plain_scene.h"

namespace fulcrum {

class InertiaCompensationEffect final : public Effect {
public:
  using Desc = InertiaCompensationDesc;
  static constexpr const char* kName = "inertia compensation";

  static std::string why_not(const Desc& desc, const PlainScene& scene);
  static void check(FigureCheck& figures, const Desc& desc);
  static std::optional<Error> refuse(const Desc& desc, const PlainScene& scene);
  static std::vector<LeftOut> left_out(const Desc& desc, const PlainScene& scene);
  static std::vector<TransientSource> transients(const Desc&, const PlainScene&) { return {}; }
  static std::optional<ChannelUse> channel_use(const Desc&, const PlainScene&) { return std::nullopt; }
  static std::optional<std::string> advise(const Desc&, const PlainScene&) { return std::nullopt; }
  // Its method is chosen on the panel of the holding point.
  static std::vector<Knob> knobs(const Desc&, const PlainScene&, const EffectRecords&) { return {}; }
  static std::optional<TorqueNote> torque_note(const Desc&, const PlainScene&, const EffectRecords&) {
    return std::nullopt;
  }
  static constexpr bool kAsksForImpacts = false;
  static constexpr bool kPushesWhileClutched = false;
  static constexpr bool kShowsGhost = false;
  static constexpr bool kTellsObjectsApart = false;

  InertiaCompensationEffect(const Desc& desc, const PlainScene& scene);

  void apply(const Command& command) noexcept override { effect_.apply(command); }
  Wrench correct(const EffectTick& tick) noexcept override;
  Settled settle(const EffectTick& tick, const Rendered& rendered) noexcept override;
  void record(EffectRecords& records) const noexcept override;
  BuiltPart part() const override;

private:
  InertiaCompensation effect_;
  bool renders_torque_;
  Vec3 axis_H_;  // (3) unit, of the stick; zero where the scene names no holding point
};

}  // namespace fulcrum
