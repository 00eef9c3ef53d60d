#pragma once
// The list of effects. One more is named in EffectDescs, in effect_records.h, and in effects.cpp, whose order
// is the order in which effects are asked at each stage of a tick, and that of sums.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "haptics/device/hand.h"
#include "haptics/effects/braking_pulse/braking_pulse.h"
#include "haptics/effects/effect.h"
#include "haptics/effects/effect_records.h"
#include "haptics/effects/guidance/guidance.h"
#include "haptics/effects/impact_vibration/impact_vibration.h"
#include "haptics/effects/inertia_compensation/inertia_compensation.h"
#include "haptics/effects/texture/texture.h"
#include "haptics/effects/torque_substitution/torque_substitution.h"
#include "haptics/effects/vibrotactile_motion/vibrotactile_motion.h"
#include "haptics/effects/workspace_walls/workspace_walls.h"
#include "haptics/math/result.h"
#include "haptics/scene/channel_use.h"
#include "haptics/scene/figure_check.h"
#include "haptics/scene/plain_scene.h"

namespace fulcrum {

// Those that a scene names.
struct EffectDescs {
  std::optional<TorqueSubstitutionDesc> torque_substitution{};
  std::optional<ImpactVibrationDesc> impact_vibration{};
  std::optional<BrakingPulseDesc> braking_pulse{};
  std::optional<VibrotactileMotionDesc> vibrotactile_motion{};
  std::optional<InertiaCompensationDesc> inertia_compensation{};
  std::optional<TextureDesc> texture{};
  std::optional<WorkspaceWallsDesc> workspace_walls{};
  std::optional<GuidanceDesc> guidance{};
};

// What they are in the scene's mirror image (math/mirror.h): each Desc has a mirror() of its own beside it.
inline void mirror(EffectDescs& descs) {
  auto& [torque_substitution, impact_vibration, braking_pulse, vibrotactile_motion, inertia_compensation,
         texture, workspace_walls, guidance] = descs;
  const auto each = [](auto&... desc) { ((desc ? mirror(*desc) : void()), ...); };
  each(torque_substitution, impact_vibration, braking_pulse, vibrotactile_motion, inertia_compensation,
       texture, workspace_walls, guidance);
}

// Whether an effect, such as BrakingPulseEffect, is built: the scene names it and its device can use it.
template <class T>
bool is_built(const PlainScene& scene, const std::optional<typename T::Desc>& desc) {
  return desc && T::why_not(*desc, scene).empty();
}

// Each figure of those that a scene names, and its range.
void check_effects(FigureCheck& figures, const EffectDescs& descs);

// The first reason why one of them cannot be, as a sentence.
std::optional<Error> refuse_effects(const PlainScene& scene, const EffectDescs& descs);

// Those that the scene names and its device can use.
std::vector<std::unique_ptr<Effect>> build_effects(const PlainScene& scene, const EffectDescs& descs);

// Whether one of those asks for impacts.
bool asks_for_impacts(const PlainScene& scene, const EffectDescs& descs);

// Whether one that the scene names does, on a device that can use it.
bool may_ask_for_impacts(const EffectDescs& descs);

// Whether one of those pushes the handle while the clutch is pressed.
bool pushes_while_clutched(const PlainScene& scene, const EffectDescs& descs);

// What those ask of the motors at a stroke.
std::vector<TransientSource> transient_sources(const PlainScene& scene, const EffectDescs& descs);

// What one of those does with the device's channels; none: nothing drives them.
std::optional<ChannelUse> channel_use(const PlainScene& scene, const EffectDescs& descs);

// What one of those tells of torque; none: none does.
std::optional<TorqueNote> torque_note(const PlainScene& scene, const EffectDescs& descs,
                                      const EffectRecords& records);

// Whether one of those shows where the hand has turned to.
bool shows_ghost(const PlainScene& scene, const EffectDescs& descs);

// Whether one of those asks which of the scene's objects was struck.
bool tells_objects_apart(const PlainScene& scene, const EffectDescs& descs);

// What the scene's objects are made of, by their numbers, for those effects that ask.
void set_materials(EffectDescs& descs, const std::vector<ImpactMaterial>& materials);

// Whether one of those that a scene names leads along the expert's way, and shows the expert's tool on it.
bool follows_expert(const EffectDescs& descs);
// That way: what the expert's hand is told, of T.
void set_expert(EffectDescs& descs, const std::vector<Waypoint>& waypoints);

// What is likely to go ill with those, sentences.
std::vector<std::string> advice_on_effects(const PlainScene& scene, const EffectDescs& descs);

// What a person can set of those, as the records have it; the same in number and order in every tick.
std::vector<Knob> effect_knobs(const PlainScene& scene, const EffectDescs& descs,
                               const EffectRecords& records);

// What the scene does without, and why.
std::vector<LeftOut> left_out_effects(const PlainScene& scene, const EffectDescs& descs);

}  // namespace fulcrum
