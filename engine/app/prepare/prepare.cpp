#include "engine/app/prepare/prepare.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "drivers/registry.h"
#include "engine/app/cli/terminal.h"
#include "engine/files/number_text.h"
#include "engine/record/motion.h"
#include "engine/scenario/content.h"
#include "engine/scenario/load.h"
#include "engine/scenario/words.h"
#include "haptics/math/functions.h"
#include "haptics/math/number_text.h"
#include "haptics/world/couple_without_motors.h"

namespace fulcrum::app {
namespace {

constexpr double kGravity = 9.80665;  // m/s^2

Error another_rate(const std::string& file, double rate_Hz) {
  const std::string sentence = "'" + file + "' was recorded at another tick rate than this scenario's, " +
                               number_text(rate_Hz, 6) + " Hz: ";
  if (!(rate_Hz >= scenario::kSlowestTicks_Hz && rate_Hz <= scenario::kFastestTicks_Hz))
    return {sentence + "no scenario can have it, only " + number_text(scenario::kSlowestTicks_Hz, 6) +
            " to " + number_text(scenario::kFastestTicks_Hz, 6) +
            " Hz. Record the motion anew, or check the times in the file."};
  std::string exactly;
  append_number(exactly, rate_Hz);
  return {sentence + "give --set tick_rate_Hz=" + exactly + "."};
}

}  // namespace

double sag(const SceneDesc& scene) {
  if (!scene.tool.weight || !coupled(scene.contact.response)) return 0;
  const double weight = std::min(scene.tool.mass * kGravity, 0.95 * scene.coupling.max_force);
  return -scene.coupling.max_force / scene.coupling.stiffness *
         math::log1p(-weight / scene.coupling.max_force);
}

std::optional<scenario::Scenario> load_named(const std::string& name_or_file,
                                             const std::vector<std::string>& overrides,
                                             const std::filesystem::path& calibration) {
  const Result<std::filesystem::path> file = scenario::find_scenario(name_or_file);
  if (!file) {
    complain(file.error().sentence);
    return std::nullopt;
  }
  scenario::Checked<scenario::Scenario> loaded = scenario::load_scenario(*file, overrides, calibration);
  if (!loaded) {
    complain("the scenario '" + name_or_file + "' cannot be used:\n" + scenario::to_text(loaded.faults()));
    return std::nullopt;
  }
  return std::move(*loaded);
}

std::optional<Prepared> prepare(const std::string& name_or_file, const std::vector<std::string>& overrides,
                                const std::filesystem::path& calibration) {
  std::optional<scenario::Scenario> loaded = load_named(name_or_file, overrides, calibration);
  if (!loaded) return std::nullopt;
  return prepare(name_or_file, std::move(*loaded));
}

Result<Prepared> prepare_quietly(const std::string& name, scenario::Scenario scenario,
                                 const std::function<void(const std::string&)>& warn,
                                 const scenario::BakeProgress& progress) {
  scenario::Checked<scenario::LoadedModels> models = scenario::load_models(scenario);
  if (!models) return Error{scenario::to_text(models.faults())};
  for (const scenario::Fault& warning : models->warnings) warn(warning.text());
  Result<scenario::HapticAssembly> haptic =
      scenario::assemble_haptic(scenario, *models, BakeCache(), progress);
  if (!haptic) return haptic.error();
  for (const std::string& warning : haptic->warnings) {
    std::string sentence = name;
    warn(sentence.append(": ").append(warning));
  }
  return Prepared{name, std::move(scenario), std::move(*models), std::move(*haptic)};
}

std::optional<Prepared> prepare(const std::string& name, scenario::Scenario scenario,
                                const scenario::BakeProgress& progress) {
  ProgressBar bar;
  Result<Prepared> prepared = prepare_quietly(
      name, std::move(scenario),
      [&](const std::string& warning) {
        bar.clear();
        complain(warning);
      },
      [&](std::string_view what, double fraction) {
        bar.show("Baking the " + std::string(what), fraction);
        if (progress) progress(what, fraction);
      });
  bar.clear();
  if (prepared) return std::move(*prepared);
  complain(prepared.error().sentence);
  return std::nullopt;
}

std::string device_in_results(const Prepared& prepared, const std::string& device) {
  const scenario::DeviceEntry& entry = prepared.scenario.device;
  if (!is_simulated(device) || !entry.own) return device;
  const auto plus = device.find('+');
  return "scenario:" + entry.model + (plus == std::string::npos ? "" : device.substr(plus));
}

std::string device_on_screen(const Prepared& prepared, const SceneDesc& scene) {
  const std::string& name = scene.device.name;
  const bool own = prepared.scenario.device.own && name == prepared.haptic.scene.device.name;
  return own ? "Scenario's own: " + name : name;
}

SceneDesc scene_for_device(const Prepared& prepared, const std::string& device) {
  SceneDesc scene = prepared.haptic.scene;
  scene.mapping.engages_at_start = pushes_back(device);
  if (!moves_as_seen(device)) return scene;
  if (!has_table(device.substr(0, device.find('+')))) {  // the scenario's device is another one
    std::optional<VibrotactileDesc> shown;  // levels that are drawn are seen and written all the same
    if (!prepared.scenario.device.beside.empty() || scenario::draws_levels(scene))
      shown = std::move(scene.device.vibrotactile);
    const std::optional<HoldingStripDesc> strip =
        senses_beside(device) ? scene.device.strip : std::optional<HoldingStripDesc>();
    scene.device = MouseDevice::mouse_desc();
    scene.device.vibrotactile = std::move(shown);
    scene.device.strip = strip;
  }
  scene.mapping = MappingDesc{};
  couple_without_motors(scene);
  return scene;
}

std::optional<Error> refuse_hand(const scenario::Scenario& scenario, const std::string& scenario_name,
                                 const std::string& hand) {
  std::vector<std::string_view> known{"still"};
  for (const scenario::HandEntry& entry : scenario.hands)
    if (entry.name != "still") known.push_back(entry.name);
  if (std::ranges::find(known, hand) != known.end()) return std::nullopt;
  return Error{"The scenario '" + scenario_name + "' has no hand " + scenario::in_quotes(hand) +
               scenario::did_you_mean(hand, known, "it has " + scenario::joined(known) + ".")};
}

Result<std::unique_ptr<SimulatedDevice>> simulated_device(const Prepared& prepared, const std::string& hand,
                                                          std::uint64_t trial) {
  if (auto refused = refuse_hand(prepared.scenario, prepared.name, hand)) return *refused;
  const SceneDesc& scene = prepared.haptic.scene;
  const auto found =
      std::find_if(prepared.haptic.hands.begin(), prepared.haptic.hands.end(),
                   [&hand](const scenario::HandScript& script) { return script.name == hand; });
  HandTask task{.path = HandPath({Waypoint{scene.tool.X_WT_start, 0, 0}}),
                .hand = {.seed = static_cast<std::uint64_t>(prepared.scenario.seed)},
                .X_HT = scene.tool.X_HT,
                .mapping = scene.mapping};
  if (found != prepared.haptic.hands.end()) {
    task.path = HandPath(found->waypoints);
    task.hand = found->desc;
  }
  task.hand.seed += trial;
  if (scene.holding_point) task.stick_H = scene.holding_point->axis_H;
  task.sag_W = Vec3(0, sag(scene), 0);
  if (scene.tool.weight) {
    const Vec3 felt_W(0, -scene.tool.mass * kGravity, 0);
    task.carried_D = -scene.mapping.wrench_in_device({felt_W, Vec3::Zero()}).force;
  }
  SimulatedDeviceDesc desc;
  desc.device = scene.device;
  desc.tick_s = scene.tick_s;
  return std::make_unique<SimulatedDevice>(desc, std::move(task));
}

Result<std::unique_ptr<ReplayDevice>> replay_device(const Prepared& prepared, const std::string& file) {
  Result<record::HandleMotion> motion = record::read_motion(file);
  if (!motion) return motion.error();
  const SceneDesc& scene = prepared.haptic.scene;
  if (std::abs(motion->tick_s - scene.tick_s) > 1e-9) return another_rate(file, 1 / motion->tick_s);
  if (motion->space == record::HandleMotion::Space::scene)
    for (DeviceSample& sample : motion->samples) sample.X_DH = scene.mapping.handle_in_device(sample.X_DH);
  return std::make_unique<ReplayDevice>(scene.device, std::move(motion->samples));
}

}  // namespace fulcrum::app
