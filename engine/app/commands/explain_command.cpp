#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string_view>

#include "drivers/registry.h"
#include "engine/app/cli/exit_code.h"
#include "engine/app/cli/headset_options.h"
#include "engine/app/cli/terminal.h"
#include "engine/app/commands/commands.h"
#include "engine/app/prepare/capabilities.h"
#include "engine/app/prepare/chosen_view.h"
#include "engine/app/prepare/device_choice.h"
#include "engine/app/prepare/inventory.h"
#include "engine/app/prepare/stage_costs.h"

namespace fulcrum::app {
namespace {

// What the response looks things up in, as often as it moves the tool: its time is the response's.
bool is_read_by_response(const SceneDesc& scene, std::string_view part) {
  constexpr std::array<std::string_view, 7> points{"field",      "pointshell", "query", "edges",
                                                   "edge query", "tool field", "voxels"};
  return scene.tool_features ? part == "features" : std::ranges::find(points, part) != points.end();
}

std::string human_bytes(std::uint64_t bytes) {
  char text[32];
  if (bytes >= 1'000'000)
    std::snprintf(text, sizeof text, "%.1f MB", static_cast<double>(bytes) * 1e-6);
  else if (bytes >= 1000)
    std::snprintf(text, sizeof text, "%.1f kB", static_cast<double>(bytes) * 1e-3);
  else
    std::snprintf(text, sizeof text, "%llu B", static_cast<unsigned long long>(bytes));
  return bytes == 0 ? "" : text;
}

std::string human_us(double us) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f us", us);
  return us > 0 ? text : "";
}

void print_items(const std::vector<InventoryItem>& items, bool with_cost) {
  std::size_t width = 0;
  for (const InventoryItem& item : items) width = std::max(width, item.name.size());
  for (const InventoryItem& item : items) {
    const std::string name = bold(item.name) + std::string(width - item.name.size(), ' ');
    if (with_cost)
      std::printf("  %s  %-8s %10s %10s  %s\n", name.c_str(), item.kind.c_str(),
                  human_bytes(item.bytes).c_str(),
                  (item.counted_in.empty() ? human_us(item.tick_us) : "in " + item.counted_in).c_str(),
                  item.note.c_str());
    else
      std::printf("  %s  %-8s %s\n", name.c_str(), item.kind.c_str(), item.note.c_str());
  }
}

// It is left out since the device has no use for it: then its note begins so.
bool is_of_device(const InventoryItem& left_out) {
  return left_out.note.starts_with("the device '");
}

void print_left_out(std::vector<InventoryItem> items) {
  const auto others = std::stable_partition(items.begin(), items.end(), is_of_device);
  const std::vector<InventoryItem> of_device(items.begin(), others);
  if (!of_device.empty()) {
    std::printf("%s\n", bold("What this device leaves out").c_str());
    print_items(of_device, false);
    std::printf("\n");
  }
  std::printf("%s\n", bold("Left out").c_str());
  print_items({others, items.end()}, false);
}

nlohmann::ordered_json to_json(const std::vector<InventoryItem>& items) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const InventoryItem& item : items)
    all.push_back(
        {{"name", item.name},
         {"kind", item.kind},
         {"bytes", item.bytes},
         {"tick_us", item.tick_us > 0 ? nlohmann::ordered_json(item.tick_us) : nullptr},
         {"counted_in", item.counted_in.empty() ? nullptr : nlohmann::ordered_json(item.counted_in)},
         {"note", item.note}});
  return all;
}

nlohmann::ordered_json left_out_as_json(const std::vector<InventoryItem>& items) {
  nlohmann::ordered_json all = to_json(items);
  for (std::size_t i = 0; i < items.size(); ++i) all[i]["by_device"] = is_of_device(items[i]);
  return all;
}

struct ExplainOptions {
  std::string scenario;
  std::vector<std::string> overrides;  // KEY=VALUE
  std::string device = "simulated";
  StereoOptions stereo;
  HeadsetOptions headset;
  bool json = false;
};

// The scenario as a device runs it. What is wrong is on stderr.
std::optional<Prepared> prepare_on(const ExplainOptions& options) {
  const Result<DeviceChoice> choice = choose_device(options.device);
  if (!choice) {
    complain(choice.error().sentence);
    return std::nullopt;
  }
  std::vector<std::string> overrides = options.overrides;
  overrides.insert(overrides.end(), choice->overrides.begin(), choice->overrides.end());
  std::optional<Prepared> prepared = prepare(options.scenario, overrides, choice->calibration);
  if (prepared && !choice->calibration.empty())
    prepared->haptic.notes.push_back("the device is calibrated, as " + choice->calibration.string() +
                                     " has it");
  if (prepared) prepared->haptic.scene = scene_for_device(*prepared, choice->device);
  return prepared;
}

std::string name_of_device(const Prepared& prepared, const std::string& asked) {
  const scenario::DeviceEntry& device = prepared.scenario.device;
  return moves_as_seen(asked) ? asked : (device.own ? "scenario:" : "") + device.model;
}

int explain_command(const ExplainOptions& options) {
  std::optional<std::string> refused = refuse_without_headset(options.headset);
  if (options.headset.asked && options.stereo.mode)
    refused = "--xr has a picture for each eye already: leave out --stereo.";
  if (refused) {
    complain(*refused);
    return kUsage;
  }
  if (options.headset.asked) {
    if (const auto refused_device = refuse_without_window(options.device, kNoWindowInHeadset)) {
      complain(refused_device->sentence);
      return kError;
    }
  }
  const std::optional<Prepared> prepared = prepare_on(options);
  if (!prepared) return kError;
  const Result<World> world = World::build(prepared->haptic.scene);
  if (!world) {
    complain(world.error().sentence);
    return kError;
  }
  const Result<scenario::VisualAssembly> visual = assemble_view(*prepared, prepared->haptic.scene, "");
  if (!visual) {
    complain(visual.error().sentence);
    return kError;
  }
  render::RenderOptions picture;
  picture.stereo = stereo_of(options.stereo);
  if (options.headset.asked) {
    picture.stereo = render::Stereo{};  // its eyes lie side by side
    picture.at_screen = false;
  }
  const Result<render::RenderPlan> plan = render::plan(visual->desc, picture);
  if (!plan) {
    complain(plan.error().sentence);
    return kError;
  }
  const std::string hand = prepared->haptic.hands.empty() ? "still" : prepared->haptic.hands.front().name;
  const Result<std::map<std::string, double>> costs = measure_stages(*prepared, hand);
  if (!costs) {
    complain(costs.error().sentence);
    return kError;
  }
  Inventory list = inventory(*world, *prepared, &*plan, {.device = options.device});
  add_scene_sound(*prepared, world->desc(), true, list);
  add_headset(options.headset, options.device, list);
  for (InventoryItem& item : list.built) {
    const auto cost = costs->find(item.name);
    if (item.kind != "haptics") continue;
    if (cost != costs->end())
      item.tick_us = cost->second;
    else if (is_read_by_response(world->desc(), item.name))
      item.counted_in = "response";
  }
  const double tick_us = costs->at("tick");
  const scenario::DeviceEntry& device = prepared->scenario.device;
  if (options.json) {
    std::printf("%s\n", nlohmann::ordered_json{{"scenario", options.scenario},
                                               {"device", name_of_device(*prepared, options.device)},
                                               {"capabilities", capabilities_as_json(world->desc().device)},
                                               {"tick_us", tick_us},
                                               {"measured_with_hand", hand},
                                               {"built", to_json(list.built)},
                                               {"left_out", left_out_as_json(list.left_out)},
                                               {"repaired", prepared->haptic.repaired}}
                            .dump(2)
                            .c_str());
    return kCompleted;
  }
  std::printf("%s\n", bold(prepared->scenario.title).c_str());
  std::printf("On %s, %s.\n%s\n\n%s\n", world->desc().device.name.c_str(),
              device.own ? "the scenario's own device" : "an installed device",
              in_lines("It " + capabilities_in_words(world->desc().device) + ".", 0).c_str(),
              bold("Built").c_str());
  print_items(list.built, true);
  std::printf("  A whole tick takes %.1f us of the processor, in the mean over the '%s' hand's motion.\n\n",
              tick_us, hand.c_str());
  print_left_out(list.left_out);
  if (!prepared->haptic.repaired.empty()) std::printf("\n%s\n", bold("Repaired").c_str());
  for (const std::string& note : prepared->haptic.repaired) std::printf("  %s\n", note.c_str());
  for (const std::string& note : prepared->haptic.notes) std::printf("%s\n", dim(note).c_str());
  return kCompleted;
}

}  // namespace

void add_explain(Program& program) {
  const auto options = std::make_shared<ExplainOptions>();
  program.add(
      "explain", "What a scenario builds, what that costs, what it leaves out",
      [options](Arguments& arguments) {
        arguments.required({"scenario", "NAME|FILE", "Its name or file"}, options->scenario);
        arguments.overrides(options->overrides);
        arguments.text({"--device", "DEVICE", "On this device (fulcrum devices): what it leaves out"},
                       options->device);
        add_stereo_mode(arguments, options->stereo);
        arguments.flag("--xr", "As a headset shows it", options->headset.asked);
        add_headset_space(arguments, options->headset);
        arguments.json("As JSON", options->json);
      },
      [options] { return explain_command(*options); });
}

}  // namespace fulcrum::app
