#pragma once
// What the list (effects.cpp) asks of an effect's class beside what Effect asks of it in a tick.

#include <concepts>
#include <optional>
#include <string>
#include <vector>

#include "haptics/effects/effect.h"
#include "haptics/math/result.h"
#include "haptics/scene/channel_use.h"
#include "haptics/scene/figure_check.h"
#include "haptics/scene/plain_scene.h"

namespace fulcrum {

template <class T>
concept ListedEffect = std::derived_from<T, Effect> &&
    std::constructible_from<T, const typename T::Desc&, const PlainScene&> &&
    requires(const typename T::Desc& desc, const PlainScene& scene, FigureCheck& figures,
             const EffectRecords& records) {
  // The key in a scenario, and the first part of its columns' names.
  { T::kName } -> std::convertible_to<const char*>;
  // Why this scene's device has no use for it, as the end of a sentence; empty: it is built.
  { T::why_not(desc, scene) } -> std::same_as<std::string>;
  // The range of each figure. A World that a program builds is held to these; a scenario's reader
  // (engine/scenario/describe_effects.cpp) gives its ranges with the keys.
  { T::check(figures, desc) } -> std::same_as<void>;
  // What cannot be with this scene, as a sentence with a remedy.
  { T::refuse(desc, scene) } -> std::same_as<std::optional<Error>>;
  // Of one that is built, the parts that this scene does without.
  { T::left_out(desc, scene) } -> std::same_as<std::vector<LeftOut>>;
  // What it asks for in strike().
  { T::transients(desc, scene) } -> std::same_as<std::vector<TransientSource>>;
  // What it does with the device's channels. One effect of a scene can drive them.
  { T::channel_use(desc, scene) } -> std::same_as<std::optional<ChannelUse>>;
  // What is likely to go ill in this scene all the same, as a sentence with a remedy.
  { T::advise(desc, scene) } -> std::same_as<std::optional<std::string>>;
  // What a person can set while it runs, as the records have it. Two knobs have two keys.
  { T::knobs(desc, scene, records) } -> std::same_as<std::vector<Knob>>;
  // What it tells of torque, where it does.
  { T::torque_note(desc, scene, records) } -> std::same_as<std::optional<TorqueNote>>;
  // Whether it sets DeviceCommand::Cues::ghost: then the tool is drawn once more, where the device senses how
  // it is turned.
  { T::kShowsGhost } -> std::convertible_to<bool>;
  // Whether it asks which of a scene's objects was struck, and of which material that is: its Desc has
  // `materials`.
  { T::kTellsObjectsApart } -> std::convertible_to<bool>;
  // Whether it reads EffectTick::impacts: else they are not looked for.
  { T::kAsksForImpacts } -> std::convertible_to<bool>;
  // Whether shape() pushes while the clutch is pressed: then the handle's way is counted there, too.
  { T::kPushesWhileClutched } -> std::convertible_to<bool>;
};

}  // namespace fulcrum
