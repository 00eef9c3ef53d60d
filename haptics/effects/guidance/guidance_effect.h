#pragma once
// Guidance in a tick: guidance.h on a scene.

#include <optional>
#include <vector>

#include "haptics/device/hand.h"
#include "haptics/effects/effect.h"
#include "haptics/effects/guidance/guidance.h"
#include "haptics/math/result.h"
#include "haptics/scene/channel_use.h"
#include "haptics/scene/figure_check.h"
#include "haptics/scene/plain_scene.h"

namespace fulcrum {

class GuidanceEffect final : public Effect {
public:
  using Desc = GuidanceDesc;
  static constexpr const char* kName = "guidance";

  // Who has no motors is shown the way all the same.
  static std::string why_not(const Desc&, const PlainScene&) { return {}; }
  static void check(FigureCheck& figures, const Desc& desc);
  static std::optional<Error> refuse(const Desc& desc, const PlainScene& scene);
  static std::vector<LeftOut> left_out(const Desc& desc, const PlainScene& scene);
  static std::vector<TransientSource> transients(const Desc&, const PlainScene&) { return {}; }
  static std::optional<ChannelUse> channel_use(const Desc&, const PlainScene&) { return std::nullopt; }
  static std::optional<std::string> advise(const Desc&, const PlainScene&) { return std::nullopt; }
  static std::vector<Knob> knobs(const Desc& desc, const PlainScene& scene, const EffectRecords& records);
  static std::optional<TorqueNote> torque_note(const Desc&, const PlainScene&, const EffectRecords&) {
    return std::nullopt;
  }
  static constexpr bool kAsksForImpacts = false;
  static constexpr bool kPushesWhileClutched = false;
  static constexpr bool kShowsGhost = false;  // of the hand; that of the expert has a pose of its own
  static constexpr bool kTellsObjectsApart = false;

  // The expert's way, by what its hand is told; waypoints: of T.
  static std::vector<GuidancePose> way_of(const std::vector<Waypoint>& waypoints);

  GuidanceEffect(const Desc& desc, const PlainScene& scene);

  void apply(const Command& command) noexcept override { effect_.apply(command); }
  Wrench shape(const EffectTick& tick) noexcept override;
  Settled settle(const EffectTick& tick, const Rendered& rendered) noexcept override;
  void record(EffectRecords& records) const noexcept override;
  BuiltPart part() const override;

private:
  Guidance effect_;
  double limit_ = 0;  // N/m, that the device holds; 0: it does not push
};

}  // namespace fulcrum
