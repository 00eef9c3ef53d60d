#pragma once
// Scenario -> what ticks (HapticAssembly) and what is drawn (VisualAssembly). Each is built only when asked
// for: a headless run draws nothing, and a picture alone needs no distance field.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/assets/bake_cache.h"
#include "engine/assets/model.h"
#include "engine/scenario/fault.h"
#include "engine/scenario/scenario.h"
#include "haptics/bake/mass_properties.h"
#include "haptics/bake/solid.h"
#include "haptics/math/result.h"

namespace fulcrum::scenario {

// The model files, read once for both assemblies.
struct LoadedModels {
  std::vector<Model> models;                // of Scenario::models, the tool's in M, the others in W
  std::vector<std::optional<Model>> drawn;  // of Scenario::models, what is drawn in a model's place
  Solid tool_T;                             // m, in T
  MassProperties tool;                      // of unit density, about T; `centre` is zero
  Vec3 p_MT =
      Vec3::Zero();  // (3) m, the centre of mass in the tool model's frame M; axes of T are those of M
  std::vector<std::string> notes;  // sentences: the tool's model was recentred, by how much
  Faults repaired;                 // what was wrong with the tool's surface, and what was guessed
  Faults warnings;                 // a model may be in another unit
  Faults lights;                   // which models bring lights
};

// Every model that cannot be used is a fault, not only the first.
Checked<LoadedModels> load_models(const Scenario& scenario);

// What is touched, as the scenario places the models' files, mended; its frame is W. A fault names each model
// that is no solid by itself.
Checked<Solid> build_scene_solid(const Scenario& scenario, const LoadedModels& models);

struct HandScript {
  std::string name;
  HandDesc desc;
  std::vector<Waypoint> waypoints;  // of T
};

struct HapticAssembly {
  SceneDesc scene;
  TaskDesc task;
  std::vector<HandScript> hands;
  Solid scene_W;  // what is touched, in W: for measuring penetration exactly, with tool_T
  Solid tool_T;
  // Which model a place belongs to, where an effect or the sound tells them apart.
  std::shared_ptr<const ObjectMap> objects;
  std::vector<ImpactMaterial> heard;  // of each model that is touched, where `sound` is named
  std::vector<std::string> notes;     // sentences: from the cache or baked in how long
  // Sentences: what runs, and may not do what its author wants; what is wrong with the cache.
  std::vector<std::string> warnings;
  std::vector<std::string> repaired;  // sentences: what was wrong with surfaces, and what was guessed
};

// `what` is being baked, "distance field"; `fraction` runs from 0 to 1, in whole percents. Called on the
// calling thread.
using BakeProgress = std::function<void(std::string_view what, double fraction)>;

Result<HapticAssembly> assemble_haptic(const Scenario& scenario, const LoadedModels& models,
                                       const BakeCache& cache, const BakeProgress& progress = {});

struct VisualAssembly {
  // The tool's instances are movable and in T: their pose is X_WT, for each of them. Those of the device's
  // links are in L, see device_links.h.
  render::VisualDesc desc;
  std::vector<View> views;  // the first is desc.camera
};

// The scenario asks for the device's arms to be drawn, and the device that ticks has such.
bool draws_arms(const Scenario& scenario, const SceneDesc& scene);

// A finger sweeps in the scene, and its device vibrates beside it: the levels are drawn.
bool draws_levels(const SceneDesc& scene);

// scene: what ticks; cues that it does not show are not drawn. Faults: each model with textures that cannot
// be used, each material that no model has, surroundings that cannot be read.
Checked<VisualAssembly> assemble_visual(const Scenario& scenario, const LoadedModels& models,
                                        const SceneDesc& scene);

}  // namespace fulcrum::scenario
