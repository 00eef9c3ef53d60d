#pragma once
// Reads a tape. One that ends early gives the whole chunks it has; one that is damaged is refused.

#include <cstddef>
#include <filesystem>
#include <span>

#include "engine/record/tape.h"
#include "haptics/math/result.h"

namespace fulcrum::record {

Result<Tape> read_tape(const std::filesystem::path& path);

// The same from memory; errors name the byte offset.
Result<Tape> parse_tape(std::span<const std::byte> bytes);

}  // namespace fulcrum::record
