#pragma once
// A scene that ticks.

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "haptics/contact/impact_detector.h"
#include "haptics/effects/effect.h"
#include "haptics/math/result.h"
#include "haptics/motion/tool_motion.h"
#include "haptics/world/handle_input.h"
#include "haptics/world/handle_output.h"
#include "haptics/world/scene_desc.h"
#include "haptics/world/stiffness_levels.h"
#include "haptics/world/tick_record.h"

namespace fulcrum {

struct StepResult {
  DeviceCommand command;
  TickRecord record;
};

class World;

// One tick: read, estimate, query, solve, couple, events, effects, guard, allocate. The only function that
// advances a World, live, offline, in replay, test and benchmark alike. May: read the sample and the
// commands, change the World. Must not and does not: lock, read a clock, touch a file, allocate, throw.
StepResult step(World& world, const DeviceSample& sample, std::span<const Command> commands) noexcept;

class World {
public:
  // Refused with a sentence: no shell or field, gains that the tick cannot hold, figures that are not finite.
  // own: effects from outside haptics/effects, asked after those that the scene names
  // (examples/own_effect.cpp). Refused where one is null or OwnRecord has no room for its values.
  static Result<World> build(SceneDesc desc, std::vector<std::unique_ptr<Effect>> own = {});

  const SceneDesc& desc() const { return desc_; }
  std::span<const ContactRegion> regions() const { return motion_->regions(); }
  std::vector<BuiltPart> parts() const;
  // What a tick's record has in this scene, before the first tick: the trace's columns follow from it.
  TickRecord blank_record() const;
  // Of this scene's last tick; none where nothing asks for impacts.
  std::span<const Impact> impacts() const {
    return impacts_ ? impacts_->impacts() : std::span<const Impact>();
  }
  // On the handle in D, of the last tick: what was commanded without the transients.
  const Wrench& continuous_F_H_D() const { return output_.continuous_F_H_D(); }
  // On the handle in D, of the last tick: what passivity control wanted beside all else.
  const Wrench& resistance_F_H_D() const { return output_.resistance_F_H_D(); }

private:
  explicit World(SceneDesc desc);
  friend StepResult step(World& world, const DeviceSample& sample,
                         std::span<const Command> commands) noexcept;

  void apply(std::span<const Command> commands) noexcept;
  // Query, solve and couple: how the tool answers to the hand. Returns the coupling's wrench on the handle.
  Wrench answer(EffectTick& tick, std::uint32_t& faults) noexcept;
  void find_impacts(EffectTick& tick) noexcept;
  // Returns what was commanded to make up for the device itself, and what the effects' springs hold.
  Settled settle(const EffectTick& tick, std::uint32_t& faults) noexcept;
  HandleOutput::Stores stores(const EffectTick& tick, double of_effects) const noexcept;
  // The parts of a record that some scenes have.
  void record_parts(TickRecord& record) const noexcept;
  StepResult leave(const EffectTick& tick, std::uint32_t faults) noexcept;

  SceneDesc desc_;
  HandleInput input_;
  std::unique_ptr<ToolMotion> motion_;
  std::optional<StiffnessLevels> stiffness_;
  std::optional<ImpactDetector> impacts_;
  std::vector<std::unique_ptr<Effect>> effects_;  // first those of the scene, then those from outside
  std::size_t listed_;                            // how many are of the scene
  HandleOutput output_;
  std::int64_t tick_ = 0;
};

}  // namespace fulcrum
