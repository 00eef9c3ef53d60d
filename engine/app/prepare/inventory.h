#pragma once
// What a scene builds and what it leaves out: the lists of `fulcrum explain` and of summary.json.

#include <string>
#include <vector>

#include "engine/app/cli/headset_options.h"
#include "engine/app/prepare/prepare.h"
#include "engine/render/plan.h"

namespace fulcrum::app {

struct InventoryItem {
  std::string name;
  std::string kind;  // "haptics", "image", "buffer", "pipeline", ...
  std::uint64_t bytes = 0;
  double tick_us = 0;        // CPU time per tick; 0: none of its own
  std::string note;          // what it is; of something left out, why
  std::string counted_in{};  // the part whose CPU time has that of this one in it; empty: none
};

struct Inventory {
  std::vector<InventoryItem> built, left_out;
};

// What a command line asks for of it.
struct InventoryOptions {
  bool circle = false;  // of confusion, with what is drawn
  bool panels = true;
  std::string device = "simulated";  // as the command line names it
};

// plan: none when nothing is drawn.
Inventory inventory(const World& world, const Prepared& prepared, const render::RenderPlan* plan,
                    const InventoryOptions& options = {});

// What is heard of the scene, to either list. heard: by somebody, or by a file.
void add_scene_sound(const Prepared& prepared, const SceneDesc& scene, bool heard, Inventory& to);

// What shows it in a headset, and whether that device is seen there where it is felt, to either list.
void add_headset(const HeadsetOptions& options, const std::string& device, Inventory& to);

}  // namespace fulcrum::app
