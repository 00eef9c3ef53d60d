#include "haptics/loop/spsc_ring.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <thread>

#include "haptics/world/tick_record.h"

namespace fulcrum {
namespace {

TEST(SpscRing, HoldsItsCapacityAndNoMore) {
  SpscRing<int> ring(3);
  EXPECT_EQ(ring.capacity(), 3u);
  int value = -1;
  EXPECT_FALSE(ring.pop(value));
  EXPECT_EQ(value, -1);
  for (int round = 0; round < 5; ++round) {  // so that the indices wrap at every phase
    EXPECT_TRUE(ring.push(1));
    EXPECT_TRUE(ring.push(2));
    EXPECT_TRUE(ring.push(3));
    EXPECT_FALSE(ring.push(4));
    for (int expected = 1; expected <= 3; ++expected) {
      ASSERT_TRUE(ring.pop(value));
      EXPECT_EQ(value, expected);
    }
    EXPECT_FALSE(ring.pop(value));
  }
}

TEST(SpscRing, KnowsHowManyWait) {
  SpscRing<int> ring(3);
  int value = 0;
  for (int round = 0; round < 5; ++round) {  // so that the indices wrap at every phase
    for (std::size_t n = 0; n < 3; ++n) {
      EXPECT_EQ(ring.size(), n);
      ring.push(1);
    }
    EXPECT_EQ(ring.size(), 3u);
    ring.push(1);
    EXPECT_EQ(ring.size(), 3u) << "there was no place";
    for (std::size_t n = 3; n > 0; --n) {
      EXPECT_EQ(ring.size(), n);
      ring.pop(value);
    }
    ring.push(1);
    ring.pop(value);
    EXPECT_EQ(ring.size(), 0u);
  }
}

TEST(SpscRing, TakesARecord) {
  SpscRing<TickRecord> ring(2);
  TickRecord record;
  record.tick = 7;
  record.X_WT.p = Vec3(1, 2, 3);
  EXPECT_TRUE(ring.push(record));
  TickRecord out;
  ASSERT_TRUE(ring.pop(out));
  EXPECT_EQ(out.tick, 7);
  EXPECT_EQ(out.X_WT.p, Vec3(1, 2, 3));
}

// Across two threads everything arrives, whole and in order. A value is wide enough that half of one would
// show.
TEST(SpscRing, KeepsOrderBetweenThreads) {
  using Value = std::array<std::uint64_t, 16>;
  constexpr std::uint64_t count = 200000;
  SpscRing<Value> ring(13);
  std::thread producer([&ring] {
    for (std::uint64_t i = 0; i < count; ++i) {
      Value value;
      value.fill(i);
      while (!ring.push(value)) std::this_thread::yield();
    }
  });
  std::uint64_t wrong = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    Value value{};
    while (!ring.pop(value)) std::this_thread::yield();
    Value expected;
    expected.fill(i);
    wrong += value == expected ? 0u : 1u;
  }
  producer.join();
  EXPECT_EQ(wrong, 0u);
}

}  // namespace
}  // namespace fulcrum
