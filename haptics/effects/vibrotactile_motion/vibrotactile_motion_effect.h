#pragma once
// Vibrotactile motion in a tick: vibrotactile_motion.h on a scene.

#include <optional>
#include <vector>

#include "haptics/effects/effect.h"
#include "haptics/effects/vibrotactile_motion/vibrotactile_motion.h"
#include "haptics/math/result.h"
#include "haptics/scene/channel_use.h"
#include "haptics/scene/figure_check.h"
#include "haptics/scene/plain_scene.h"

namespace fulcrum {

class VibrotactileMotionEffect final : public Effect {
public:
  using Desc = VibrotactileMotionDesc;
  static constexpr const char* kName = "vibrotactile motion";

  // As a fallback it is for a device that has channels and no motors. Else it needs channels, or a device
  // that pushes and a lateral force.
  static std::string why_not(const Desc& desc, const PlainScene& scene);
  static void check(FigureCheck& figures, const Desc& desc);
  static std::optional<Error> refuse(const Desc& desc, const PlainScene& scene);
  static std::vector<LeftOut> left_out(const Desc& desc, const PlainScene& scene);
  static std::vector<TransientSource> transients(const Desc&, const PlainScene&) { return {}; }
  static std::optional<ChannelUse> channel_use(const Desc& desc, const PlainScene& scene);
  static std::optional<std::string> advise(const Desc& desc, const PlainScene& scene);
  static std::vector<Knob> knobs(const Desc& desc, const PlainScene& scene, const EffectRecords& records);
  static std::optional<TorqueNote> torque_note(const Desc&, const PlainScene&, const EffectRecords&) {
    return std::nullopt;
  }
  static constexpr bool kAsksForImpacts = false;
  static constexpr bool kPushesWhileClutched = false;
  static constexpr bool kShowsGhost = false;
  static constexpr bool kTellsObjectsApart = false;

  VibrotactileMotionEffect(const Desc& desc, const PlainScene& scene);

  void apply(const Command& command) noexcept override { effect_.apply(command); }
  Wrench shape(const EffectTick& tick) noexcept override;
  void command(const EffectTick& tick, double gain, bool stopped, DeviceCommand& command) noexcept override;
  void record(EffectRecords& records) const noexcept override;
  BuiltPart part() const override;

private:
  MappingDesc mapping_;
  bool renders_force_;
  std::optional<VibrotactileDesc> channels_;
  VibrotactileMotion effect_;
};

}  // namespace fulcrum
