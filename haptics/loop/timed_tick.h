#pragma once
// A tick as other threads hear of it: what it left behind, and when.

#include <cstdint>

#include "haptics/loop/spsc_ring.h"
#include "haptics/world/tick_record.h"

namespace fulcrum {

struct TimedTick {
  TickRecord record;
  std::int64_t at_ns = 0;       // by AgeClock, when it had ended
  std::int64_t sampled_ns = 0;  // by AgeClock, when the pose that it began with was measured
};

using TimedTicks = SpscRing<TimedTick>;

}  // namespace fulcrum
