#pragma once
// A trial's ticks to look back at: so many of them, evenly over the trial, that memory stays bounded however
// long it is.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "haptics/world/tick_record.h"

namespace fulcrum::app {

class Film {
public:
  static constexpr std::size_t kMost = 6000;      // frames
  static constexpr double kFirstInterval = 0.02;  // s; twice as long whenever there would be more

  explicit Film(double tick_s)
      : ticks_each_(std::max<std::int64_t>(1, std::llround(kFirstInterval / tick_s))) {}

  // time: s of the trial, after that tick; it never goes back.
  void add(const TickRecord& record, double time) {
    if (ticks_++ % ticks_each_ != 0) return;
    if (frames_.size() == kMost) {
      for (std::size_t i = 0; i < kMost / 2; ++i) frames_[i] = frames_[2 * i];
      frames_.resize(kMost / 2);
      ticks_each_ *= 2;
      if ((ticks_ - 1) % ticks_each_ != 0) return;
    }
    frames_.push_back({time, record});
  }

  bool empty() const { return frames_.empty(); }
  std::size_t frames() const { return frames_.size(); }
  // The last frame that is no later; the first, where all are. Not of an empty film.
  const TickRecord& at(double time) const {
    const auto after = std::ranges::upper_bound(frames_, time, {}, &Frame::time);
    return (after == frames_.begin() ? after : after - 1)->record;
  }

private:
  struct Frame {
    double time = 0;  // s
    TickRecord record;
  };
  std::int64_t ticks_each_, ticks_ = 0;
  std::vector<Frame> frames_;
};

}  // namespace fulcrum::app
