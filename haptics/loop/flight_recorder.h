#pragma once
// The last ticks, kept in memory sized once, so that a fault can be looked at with what led to it.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "haptics/world/tick_record.h"

namespace fulcrum {

struct FlightEntry {
  TickRecord record;
  std::int32_t task_step = 0;
  std::optional<std::int64_t> hard_touches{};  // none: the task does not count them
};

class FlightRecorder {
public:
  explicit FlightRecorder(std::size_t capacity) : entries_(capacity) {}

  // Does not allocate; the oldest entry makes room.
  void push(const FlightEntry& entry) noexcept {
    entries_[next_] = entry;
    next_ = next_ + 1 == entries_.size() ? 0 : next_ + 1;
    size_ += size_ < entries_.size() ? 1 : 0;
  }

  std::size_t size() const { return size_; }
  // 0 is the oldest kept.
  const FlightEntry& operator[](std::size_t i) const {
    return entries_[(next_ + entries_.size() - size_ + i) % entries_.size()];
  }

private:
  std::vector<FlightEntry> entries_;
  std::size_t next_ = 0;
  std::size_t size_ = 0;
};

}  // namespace fulcrum
