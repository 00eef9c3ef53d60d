#pragma once
// The visitor that reads: takes each described key from a tree, and says what is wrong with the tree.

#include <filesystem>
#include <string>
#include <string_view>

#include "engine/scenario/fault.h"
#include "engine/scenario/key_visitor.h"
#include "engine/scenario/yaml_tree.h"

namespace fulcrum::scenario {

// Reads `root` as the description says. Files are resolved in `folder`. What has a fault keeps its default.
Faults read_tree(const Node& root, const std::filesystem::path& folder, const Describe& describe);

}  // namespace fulcrum::scenario
