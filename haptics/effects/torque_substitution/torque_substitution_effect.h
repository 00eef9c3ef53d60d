#pragma once
// Torque substitution in a tick: torque_substitution.h on a scene.

#include <optional>
#include <vector>

#include "haptics/effects/effect.h"
#include "haptics/effects/torque_substitution/torque_substitution.h"
#include "haptics/math/result.h"
#include "haptics/scene/channel_use.h"
#include "haptics/scene/figure_check.h"
#include "haptics/scene/plain_scene.h"

namespace fulcrum {

class TorqueSubstitutionEffect final : public Effect {
public:
  using Desc = TorqueSubstitutionDesc;
  static constexpr const char* kName = "torque substitution";

  // Empty: it is built. Else why this device has no use for it.
  static std::string why_not(const Desc& desc, const PlainScene& scene);
  // Each figure of it, and its range.
  static void check(FigureCheck& figures, const Desc& desc);
  static std::optional<Error> refuse(const Desc& desc, const PlainScene& scene);
  // Parts of it that this scene does without; it is built.
  static std::vector<LeftOut> left_out(const Desc& desc, const PlainScene& scene);
  static std::vector<TransientSource> transients(const Desc& desc, const PlainScene& scene);
  static std::optional<ChannelUse> channel_use(const Desc&, const PlainScene&) { return std::nullopt; }
  static std::optional<std::string> advise(const Desc&, const PlainScene&) { return std::nullopt; }
  // What a person can set of it in this scene, as the records have it.
  static std::vector<Knob> knobs(const Desc& desc, const PlainScene& scene, const EffectRecords& records);
  static std::optional<TorqueNote> torque_note(const Desc& desc, const PlainScene& scene,
                                               const EffectRecords& records);
  static constexpr bool kAsksForImpacts = false;
  static constexpr bool kPushesWhileClutched = false;
  static constexpr bool kShowsGhost = true;
  static constexpr bool kTellsObjectsApart = false;

  TorqueSubstitutionEffect(const Desc& desc, const PlainScene& scene);

  void apply(const Command& command) noexcept override { effect_.apply(command); }
  std::optional<Transient> strike(const EffectTick& tick) noexcept override;
  Settled settle(const EffectTick& tick, const Rendered& rendered) noexcept override;
  void command(const EffectTick& tick, double gain, bool stopped, DeviceCommand& command) noexcept override;
  void record(EffectRecords& records) const noexcept override;
  BuiltPart part() const override;

private:
  TorqueSubstitution effect_;
  double tool_weight_;  // N
  Quat q_DW_;
  double torque_limit_ = TorqueLimit::kNone;  // N m
  double energy_ = 0;                         // J
};

}  // namespace fulcrum
