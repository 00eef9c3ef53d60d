#pragma once
// --set KEY=VALUE, written into a file's tree before it is read: an override passes every check a file does.

#include <span>
#include <string>

#include "engine/scenario/fault.h"
#include "engine/scenario/key_list.h"
#include "engine/scenario/yaml_tree.h"

namespace fulcrum::scenario {

// In order; a later one replaces an earlier one. `keys`: what the file may hold.
Faults apply_overrides(Node& root, std::span<const std::string> overrides, std::span<const KeyEntry> keys);

}  // namespace fulcrum::scenario
