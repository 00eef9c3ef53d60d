#pragma once
// The newest value from one thread to one other: a triple buffer. The writer never waits for the reader, the
// reader never sees half a value, and values that were not read in time are passed over.

#include <array>
#include <atomic>
#include <cstdint>

namespace fulcrum {

template <class T>
class Snapshot {
public:
  // The writer's thread only. Fill draft(), whose contents are those of some older value, then publish().
  T& draft() noexcept { return slots_[draft_].value; }
  void publish() noexcept { draft_ = middle_.exchange(draft_ | kFresh, std::memory_order_acq_rel) & kIndex; }

  // The reader's thread only. The newest published value; before the first one, a default T. The reference
  // stays valid, and the value unchanged, until the next newest().
  const T& newest() noexcept {
    if ((middle_.load(std::memory_order_relaxed) & kFresh) != 0)
      front_ = middle_.exchange(front_, std::memory_order_acq_rel) & kIndex;
    return slots_[front_].value;
  }

private:
  static constexpr std::uint32_t kIndex = 3, kFresh = 4;

  struct alignas(64) Slot {
    T value{};
  };

  std::array<Slot, 3> slots_;
  alignas(64) std::uint32_t draft_ = 0;  // the writer's
  alignas(64) std::atomic<std::uint32_t> middle_{
      1};                                // handed over: index, and whether the reader has yet to see it
  alignas(64) std::uint32_t front_ = 2;  // the reader's
};

}  // namespace fulcrum
