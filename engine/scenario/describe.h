#pragma once
// The descriptions of the files: every key with its type, unit, range, default and meaning, said once.

#include <array>
#include <initializer_list>
#include <string_view>
#include <vector>

#include "engine/scenario/key_visitor.h"

namespace fulcrum::scenario {

inline constexpr std::int64_t kFormatVersion = 1;

// scenario.yaml. `scenario` gives the defaults and takes what is read.
void describe_scenario(KeyVisitor& visitor, Scenario& scenario);

// The file that a hand's `path` names.
void describe_hand_path(KeyVisitor& visitor, std::vector<Waypoint>& waypoints);

// content/devices/NAME.yaml
void describe_device_file(KeyVisitor& visitor, DeviceDesc& device);

// content/materials/NAME.yaml
void describe_material_file(KeyVisitor& visitor, ImpactMaterial& material);

// Parts of describe_scenario(), in files of their own.
void describe_tool(KeyVisitor& visitor, ToolEntry& tool);
void describe_task(KeyVisitor& visitor, Scenario& scenario);       // checkpoints to variant
void describe_mechanics(KeyVisitor& visitor, Scenario& scenario);  // field to device
void describe_effects(KeyVisitor& visitor, Scenario& scenario);
// Where a scenario says what models are made of that do not say so themselves.
std::initializer_list<std::string_view> impact_material_key();
// After effects and hands: whoever leads along the expert's way needs an expert.
void check_expert(KeyVisitor& visitor, const Scenario& scenario);
void describe_effects_of_device(KeyVisitor& visitor, Scenario& scenario);  // within 'device'
void describe_look(KeyVisitor& visitor, Scenario& scenario);               // views to background
void describe_sound(KeyVisitor& visitor, Scenario& scenario);
// Where a scenario says what sounds are made of that no model says.
std::initializer_list<std::string_view> sound_material_key();

}  // namespace fulcrum::scenario
