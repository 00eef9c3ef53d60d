#pragma once
// The haptic thread: step() at absolute deadlines. Everything else stays on its own side of two rings and a
// snapshot.

#include <array>
#include <atomic>
#include <cstdint>
#include <string>
#include <thread>

#include "haptics/device/device.h"
#include "haptics/loop/snapshot.h"
#include "haptics/loop/spsc_ring.h"
#include "haptics/loop/tick_event.h"
#include "haptics/loop/timed_tick.h"
#include "haptics/loop/wake.h"
#include "haptics/world/world.h"

namespace fulcrum {

// What the operating system refused (real_time.h); empty when granted.
struct RealTimeGrant {
  std::string scheduling;
  std::string memory;
};

// How late ticks began: bucket 0 counts those less than 1 us late, bucket i those less than 2^i us.
using LateHistogram = std::array<std::uint64_t, 20>;

class LiveLoop {
public:
  LiveLoop(World& world, Device& device);
  ~LiveLoop();  // stops
  LiveLoop(const LiveLoop&) = delete;
  LiveLoop& operator=(const LiveLoop&) = delete;

  // Before start(): one more thread is told of every tick, through a ring of its own, which must outlive the
  // loop's thread. What finds no place in it is left out.
  void also_tell(TimedTicks& ring) { told_ = &ring; }

  void start();
  void stop();  // waits for the thread

  // Main thread. False: the queue is full and the command was not taken.
  bool send(const Command& command) { return commands_.push(command); }
  // Main thread: it is about to do what may never end, such as to wait for a headset. Where it does not say
  // within limit (s) that it has done so, the force is stopped (Command::unanswered).
  void expect_word_within(double limit);
  // Main thread: it has. False: too late, and the force was stopped.
  bool gives_word() { return word_due_ns_.exchange(kNoWord, std::memory_order_relaxed) != kWordMissed; }

  // Main thread: every tick, in order. False: none is waiting.
  bool next(TickEvent& event) { return events_.pop(event); }
  // Main thread: the newest tick; it stays as it is until the next call of either.
  const TickRecord& newest() { return newest_timed().record; }
  const TimedTick& newest_timed() { return snapshot_.newest(); }

  // Ticks that the main thread left in the ring until it was full. They ran, but no record of them is left.
  std::uint64_t unrecorded() const { return unrecorded_.load(std::memory_order_relaxed); }
  // Ticks that ran and began a tick or more after they were due.
  std::uint64_t late_ticks() const { return late_.load(std::memory_order_relaxed); }
  std::uint64_t lost_ticks() const { return lost_.load(std::memory_order_relaxed); }

  // After stop().
  const RealTimeGrant& grant() const { return grant_; }
  const LateHistogram& late_histogram() const { return histogram_; }

private:
  static constexpr std::int64_t kNoWord = 0, kWordMissed = -1;  // of word_due_ns_: none is expected; too late

  void run();
  // Whether it is due at that time: true once.
  bool misses_word(std::int64_t now_ns) noexcept;

  World& world_;
  Device& device_;
  SpscRing<Command> commands_{64};
  SpscRing<TickEvent> events_;
  TimedTicks* told_ = nullptr;  // null: nobody else listens
  Snapshot<TimedTick> snapshot_;
  std::atomic<bool> running_{false};
  std::atomic<std::int64_t> word_due_ns_{kNoWord};  // by AgeClock
  std::atomic<std::uint64_t> unrecorded_{0}, late_{0}, lost_{0};
  RealTimeGrant grant_;
  LateHistogram histogram_{};
  std::thread thread_;
};

}  // namespace fulcrum
