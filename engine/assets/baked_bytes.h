#pragma once
// Baked things as bytes. A change of either format, or of the last bit of what
// a bake gives, needs a new kBakeFormat.

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "haptics/geometry/distance_field.h"
#include "haptics/geometry/pointshell.h"

namespace fulcrum {

inline constexpr std::string_view kBakeFormat = "fulcrum bake 4";

std::vector<std::byte> to_bytes(const DistanceField& field);
std::vector<std::byte> to_bytes(const Pointshell& shell);

// Nothing if the bytes are not of one piece: lengths that disagree, indices out of range, numbers that are
// not finite.
std::optional<DistanceField> field_from_bytes(std::span<const std::byte> bytes);
std::optional<Pointshell> pointshell_from_bytes(std::span<const std::byte> bytes);

}  // namespace fulcrum
