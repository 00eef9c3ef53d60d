#pragma once
// What reading alone costs: four gathers of int16 pairs for each point, where a query would read, and no
// arithmetic but what keeps them.

#include <cstdint>
#include <span>

namespace fulcrum::bench {

// offsets: bytes from `values` to each cell's lowest corner, a multiple of 16 of them.
std::int32_t read_alone(const std::int16_t* values, std::span<const std::int32_t> offsets);

}  // namespace fulcrum::bench
