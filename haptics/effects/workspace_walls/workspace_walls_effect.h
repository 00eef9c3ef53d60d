#pragma once
// Workspace walls in a tick: workspace_walls.h on a scene.

#include <optional>
#include <vector>

#include "haptics/effects/effect.h"
#include "haptics/effects/workspace_walls/workspace_walls.h"
#include "haptics/math/result.h"
#include "haptics/scene/channel_use.h"
#include "haptics/scene/figure_check.h"
#include "haptics/scene/plain_scene.h"

namespace fulcrum {

class WorkspaceWallsEffect final : public Effect {
public:
  using Desc = WorkspaceWallsDesc;
  static constexpr const char* kName = "workspace walls";

  static std::string why_not(const Desc& desc, const PlainScene& scene);
  static void check(FigureCheck& figures, const Desc& desc);
  static std::optional<Error> refuse(const Desc& desc, const PlainScene& scene);
  static std::vector<LeftOut> left_out(const Desc&, const PlainScene&) { return {}; }
  static std::vector<TransientSource> transients(const Desc&, const PlainScene&) { return {}; }
  static std::optional<ChannelUse> channel_use(const Desc&, const PlainScene&) { return std::nullopt; }
  static std::optional<std::string> advise(const Desc&, const PlainScene&) { return std::nullopt; }
  static std::vector<Knob> knobs(const Desc&, const PlainScene&, const EffectRecords&) { return {}; }
  static std::optional<TorqueNote> torque_note(const Desc&, const PlainScene&, const EffectRecords&) {
    return std::nullopt;
  }
  static constexpr bool kAsksForImpacts = false;
  static constexpr bool kPushesWhileClutched = true;
  static constexpr bool kShowsGhost = false;
  static constexpr bool kTellsObjectsApart = false;

  WorkspaceWallsEffect(const Desc& desc, const PlainScene& scene);

  Wrench shape(const EffectTick& tick) noexcept override;
  Settled settle(const EffectTick& tick, const Rendered& rendered) noexcept override;
  void record(EffectRecords& records) const noexcept override;
  BuiltPart part() const override;

private:
  WorkspaceWalls effect_;
  double margin_, limit_;  // m, N/m
};

}  // namespace fulcrum
