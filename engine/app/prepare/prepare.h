#pragma once
// From a name on the command line to something that can run.

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drivers/replay/replay_device.h"
#include "engine/scenario/assemble.h"
#include "engine/scenario/fault.h"
#include "engine/scenario/scenario.h"
#include "haptics/device/simulated_device.h"
#include "haptics/world/world.h"

namespace fulcrum::app {

struct Prepared {
  std::string name;  // as it was asked for
  scenario::Scenario scenario;
  scenario::LoadedModels models;
  scenario::HapticAssembly haptic;
};

// Every sentence that is wrong about it is written to stderr; then nothing is returned. load_named() reads
// the scenario's file alone; prepare() its models, too, and bakes what is not in the cache. progress: told
// besides the terminal, on the calling thread; what it throws ends the bake and comes out of prepare().
// calibration: of the device that a person holds, see load_scenario().
std::optional<scenario::Scenario> load_named(const std::string& name_or_file,
                                             const std::vector<std::string>& overrides,
                                             const std::filesystem::path& calibration = {});
std::optional<Prepared> prepare(const std::string& name_or_file, const std::vector<std::string>& overrides,
                                const std::filesystem::path& calibration = {});
std::optional<Prepared> prepare(const std::string& name, scenario::Scenario scenario,
                                const scenario::BakeProgress& progress = {});

// The same without a word on stderr: what is wrong is the error. warn: told at once, before what may take
// long, of what may not be meant.
Result<Prepared> prepare_quietly(const std::string& name, scenario::Scenario scenario,
                                 const std::function<void(const std::string&)>& warn,
                                 const scenario::BakeProgress& progress);

// What results call a device that the command line named `device`: the scenario's own is scenario:MODEL.
std::string device_in_results(const Prepared& prepared, const std::string& device);

// What panels and pages call the device of a scene that is the scenario's, or one that stands in for it: of
// the scenario's own they say so.
std::string device_on_screen(const Prepared& prepared, const SceneDesc& scene);

// The scene as this device runs it: one that moves as it is seen moves the handle itself, without a scale,
// and renders no force.
SceneDesc scene_for_device(const Prepared& prepared, const std::string& device);

// m, how far the coupling yields under the tool's weight: a hand aims so much higher than its path says.
double sag(const SceneDesc& scene);

// Why the scenario has no hand of that name, with those that it has; absent: it has one. `still` is always
// there. Known before anything is baked.
std::optional<Error> refuse_hand(const scenario::Scenario& scenario, const std::string& scenario_name,
                                 const std::string& hand);

// The scenario's hand of that name. trial: added to the scenario's seed, for the same hand on another day.
Result<std::unique_ptr<SimulatedDevice>> simulated_device(const Prepared& prepared, const std::string& hand,
                                                          std::uint64_t trial = 0);

// A tape's or a trace's handle motion, for --device replay:FILE.
Result<std::unique_ptr<ReplayDevice>> replay_device(const Prepared& prepared, const std::string& file);

}  // namespace fulcrum::app
