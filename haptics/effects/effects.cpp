#include "haptics/effects/effects.h"

#include "haptics/effects/braking_pulse/braking_pulse_effect.h"
#include "haptics/effects/guidance/guidance_effect.h"
#include "haptics/effects/impact_vibration/impact_vibration_effect.h"
#include "haptics/effects/inertia_compensation/inertia_compensation_effect.h"
#include "haptics/effects/listed_effect.h"
#include "haptics/effects/texture/texture_effect.h"
#include "haptics/effects/torque_substitution/torque_substitution_effect.h"
#include "haptics/effects/vibrotactile_motion/vibrotactile_motion_effect.h"
#include "haptics/effects/workspace_walls/workspace_walls_effect.h"

namespace fulcrum {
namespace {

// Calls f(list entry, its Desc or null) for each effect; the list entry is the type of the effect.
template <ListedEffect T>
struct Entry {
  using Type = T;
};
template <class Descs, class F>  // (Entry<EffectType>, std::optional<EffectType::Desc>&)
void for_each_effect(Descs& descs, F&& f) {
  f(Entry<TorqueSubstitutionEffect>(), descs.torque_substitution);
  f(Entry<ImpactVibrationEffect>(), descs.impact_vibration);
  f(Entry<BrakingPulseEffect>(), descs.braking_pulse);
  f(Entry<VibrotactileMotionEffect>(), descs.vibrotactile_motion);
  f(Entry<InertiaCompensationEffect>(), descs.inertia_compensation);
  f(Entry<TextureEffect>(), descs.texture);
  f(Entry<WorkspaceWallsEffect>(), descs.workspace_walls);
  f(Entry<GuidanceEffect>(), descs.guidance);
}

// Of those alone that are built.
template <class F>
void for_each_built(const PlainScene& scene, const EffectDescs& descs, F&& f) {
  for_each_effect(
      descs,
      [&]<class T>(Entry<T> entry, const std::optional<typename T::Desc>& desc) {
        if (is_built<T>(scene, desc)) f(entry, *desc);
      });
}

}  // namespace

void check_effects(FigureCheck& figures, const EffectDescs& descs) {
  for_each_effect(
      descs,
      [&]<class T>(Entry<T>, const std::optional<typename T::Desc>& desc) {
        if (desc) T::check(figures, *desc);
      });
}

std::optional<Error> refuse_effects(const PlainScene& scene, const EffectDescs& descs) {
  std::optional<Error> error;
  for_each_effect(descs, [&]<class T>(Entry<T>, const std::optional<typename T::Desc>& desc) {
    if (desc && !error) error = T::refuse(*desc, scene);
  });
  return error;
}

std::vector<std::unique_ptr<Effect>> build_effects(const PlainScene& scene, const EffectDescs& descs) {
  std::vector<std::unique_ptr<Effect>> effects;
  for_each_built(scene, descs, [&]<class T>(Entry<T>, const typename T::Desc& desc) {
    effects.push_back(std::make_unique<T>(desc, scene));
  });
  return effects;
}

bool asks_for_impacts(const PlainScene& scene, const EffectDescs& descs) {
  bool asks = false;
  for_each_built(scene, descs,
                 [&]<class T>(Entry<T>, const typename T::Desc&) { asks = asks || T::kAsksForImpacts; });
  return asks;
}

bool may_ask_for_impacts(const EffectDescs& descs) {
  bool asks = false;
  for_each_effect(
      descs,
      [&]<class T>(Entry<T>, const std::optional<typename T::Desc>& desc) {
        asks = asks || (desc && T::kAsksForImpacts);
      });
  return asks;
}

bool pushes_while_clutched(const PlainScene& scene, const EffectDescs& descs) {
  bool pushes = false;
  for_each_built(scene, descs, [&]<class T>(Entry<T>, const typename T::Desc&) {
    pushes = pushes || T::kPushesWhileClutched;
  });
  return pushes;
}

std::vector<TransientSource> transient_sources(const PlainScene& scene, const EffectDescs& descs) {
  std::vector<TransientSource> sources;
  for_each_built(scene, descs, [&]<class T>(Entry<T>, const typename T::Desc& desc) {
    const std::vector<TransientSource> own = T::transients(desc, scene);
    sources.insert(sources.end(), own.begin(), own.end());
  });
  return sources;
}

std::optional<ChannelUse> channel_use(const PlainScene& scene, const EffectDescs& descs) {
  std::optional<ChannelUse> use;
  for_each_built(scene, descs, [&]<class T>(Entry<T>, const typename T::Desc& desc) {
    if (!use) use = T::channel_use(desc, scene);
  });
  return use;
}

std::optional<TorqueNote> torque_note(const PlainScene& scene, const EffectDescs& descs,
                                      const EffectRecords& records) {
  std::optional<TorqueNote> note;
  for_each_built(scene, descs, [&]<class T>(Entry<T>, const typename T::Desc& desc) {
    if (!note) note = T::torque_note(desc, scene, records);
  });
  return note;
}

bool shows_ghost(const PlainScene& scene, const EffectDescs& descs) {
  bool shows = false;
  for_each_built(scene, descs,
                 [&]<class T>(Entry<T>, const typename T::Desc&) { shows = shows || T::kShowsGhost; });
  return shows && scene.device.senses_rotation;
}

bool tells_objects_apart(const PlainScene& scene, const EffectDescs& descs) {
  bool tells = false;
  for_each_built(scene, descs,
                 [&]<class T>(Entry<T>, const typename T::Desc&) { tells = tells || T::kTellsObjectsApart; });
  return tells;
}

void set_materials(EffectDescs& descs, const std::vector<ImpactMaterial>& materials) {
  for_each_effect(
      descs,
      [&]<class T>(Entry<T>, std::optional<typename T::Desc>& desc) {
        if constexpr (T::kTellsObjectsApart)
          if (desc) desc->materials = materials;
      });
}

bool follows_expert(const EffectDescs& descs) {
  return descs.guidance.has_value();
}

void set_expert(EffectDescs& descs, const std::vector<Waypoint>& waypoints) {
  if (descs.guidance) descs.guidance->way = GuidanceEffect::way_of(waypoints);
}

std::vector<std::string> advice_on_effects(const PlainScene& scene, const EffectDescs& descs) {
  std::vector<std::string> advice;
  for_each_built(scene, descs, [&]<class T>(Entry<T>, const typename T::Desc& desc) {
    if (const auto sentence = T::advise(desc, scene)) advice.push_back(*sentence);
  });
  return advice;
}

std::vector<Knob> effect_knobs(const PlainScene& scene, const EffectDescs& descs,
                               const EffectRecords& records) {
  std::vector<Knob> knobs;
  for_each_built(scene, descs, [&]<class T>(Entry<T>, const typename T::Desc& desc) {
    for (Knob& knob : T::knobs(desc, scene, records)) {
      knob.effect = T::kName;
      knobs.push_back(knob);
    }
  });
  return knobs;
}

std::vector<LeftOut> left_out_effects(const PlainScene& scene, const EffectDescs& descs) {
  std::vector<LeftOut> parts;
  for_each_effect(descs, [&]<class T>(Entry<T>, const std::optional<typename T::Desc>& desc) {
    const std::string why = desc ? T::why_not(*desc, scene) : "the scenario does not name it";
    if (!why.empty()) {
      parts.push_back({T::kName, why});
      return;
    }
    const std::vector<LeftOut> own = T::left_out(*desc, scene);
    parts.insert(parts.end(), own.begin(), own.end());
  });
  return parts;
}

}  // namespace fulcrum
