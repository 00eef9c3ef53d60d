#pragma once
// A tick as a thread beside the main one hears of it: what it left behind, and when.

#include <cstdint>

#include "haptics/loop/spsc_ring.h"
#include "haptics/world/tick_record.h"

namespace fulcrum {

struct TimedTick {
  TickRecord record;
  std::int64_t at_ns = 0;  // by AgeClock, when it had ended
};

using TimedTicks = SpscRing<TimedTick>;

}  // namespace fulcrum
