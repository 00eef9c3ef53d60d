#pragma once
// The visitor that writes: a description -> JSON Schema, draft 2020-12.

#include <nlohmann/json.hpp>
#include <string_view>

#include "engine/scenario/key_visitor.h"

namespace fulcrum::scenario {

// Keys stand in the order of the description.
nlohmann::ordered_json write_schema(std::string_view title, const Describe& describe);

}  // namespace fulcrum::scenario
