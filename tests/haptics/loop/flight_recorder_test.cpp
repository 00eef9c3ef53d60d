#include "haptics/loop/flight_recorder.h"

#include <gtest/gtest.h>

namespace fulcrum {
namespace {

TEST(FlightRecorder, KeepsTheNewestOldestFirst) {
  FlightRecorder recorder(3);
  EXPECT_EQ(recorder.size(), 0u);
  for (std::int64_t tick = 0; tick < 8; ++tick) {
    FlightEntry entry;
    entry.record.tick = tick;
    entry.task_step = static_cast<std::int32_t>(10 * tick);
    recorder.push(entry);
    const std::int64_t kept = std::min<std::int64_t>(tick + 1, 3);
    ASSERT_EQ(recorder.size(), static_cast<std::size_t>(kept));
    for (std::int64_t i = 0; i < kept; ++i) {
      const FlightEntry& seen = recorder[static_cast<std::size_t>(i)];
      EXPECT_EQ(seen.record.tick, tick - kept + 1 + i);
      EXPECT_EQ(seen.task_step, 10 * seen.record.tick);
    }
  }
}

}  // namespace
}  // namespace fulcrum
