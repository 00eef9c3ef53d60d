#pragma once
// 64 bits that stand for every bit of a tick's record.

#include <cstdint>

#include "haptics/world/tick_record.h"

namespace fulcrum::record {

// Of the fields' values in the order in which describe() names them, never of padding; 0 and -0 differ.
std::uint64_t digest(const TickRecord& record);

}  // namespace fulcrum::record
