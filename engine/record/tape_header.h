#pragma once
// The header of a tape as JSON.

#include <string>
#include <string_view>

#include "engine/record/tape.h"
#include "haptics/math/result.h"

namespace fulcrum::record {

Result<std::string> tape_header_json(const TapeHeader& header);
Result<TapeHeader> parse_tape_header(std::string_view json);

}  // namespace fulcrum::record
