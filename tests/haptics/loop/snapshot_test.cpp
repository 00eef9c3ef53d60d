#include "haptics/loop/snapshot.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <thread>

namespace fulcrum {
namespace {

TEST(Snapshot, GivesTheNewestAgainAndAgain) {
  Snapshot<int> snapshot;
  EXPECT_EQ(snapshot.newest(), 0);
  snapshot.draft() = 1;
  snapshot.publish();
  snapshot.draft() = 2;
  snapshot.publish();
  EXPECT_EQ(snapshot.newest(), 2);
  EXPECT_EQ(snapshot.newest(), 2);
  snapshot.draft() = 3;
  EXPECT_EQ(snapshot.newest(), 2) << "a draft is not seen before it is published";
  snapshot.publish();
  EXPECT_EQ(snapshot.newest(), 3);
}

TEST(Snapshot, WhatWasReadStaysUntilTheNextRead) {
  Snapshot<int> snapshot;
  snapshot.draft() = 1;
  snapshot.publish();
  const int& read = snapshot.newest();
  for (int i = 2; i < 10; ++i) {
    snapshot.draft() = i;
    snapshot.publish();
    EXPECT_EQ(read, 1);
  }
  EXPECT_EQ(snapshot.newest(), 9);
}

// Across two threads: never half a value, never back in time, and the last one arrives.
TEST(Snapshot, IsWholeAndForwardBetweenThreads) {
  using Value = std::array<std::uint64_t, 32>;
  constexpr std::uint64_t count = 200000;
  Snapshot<Value> snapshot;
  std::atomic<bool> done{false};
  std::thread writer([&] {
    for (std::uint64_t i = 1; i <= count; ++i) {
      snapshot.draft().fill(i);
      snapshot.publish();
    }
    done.store(true, std::memory_order_release);
  });
  std::uint64_t torn = 0, backwards = 0, previous = 0;
  bool last_round = false;
  while (!last_round) {
    last_round = done.load(std::memory_order_acquire);
    const Value& value = snapshot.newest();
    for (const std::uint64_t part : value) torn += part == value.front() ? 0u : 1u;
    backwards += value.front() < previous ? 1u : 0u;
    previous = value.front();
  }
  writer.join();
  EXPECT_EQ(torn, 0u);
  EXPECT_EQ(backwards, 0u);
  EXPECT_EQ(previous, count);
}

}  // namespace
}  // namespace fulcrum
