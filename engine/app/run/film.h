#pragma once
// A trial to look back at: so many of its ticks, evenly over it, that memory stays bounded however long it
// is.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "haptics/world/tick_record.h"

namespace fulcrum::app {

// T: what is kept of a tick. kMost_: frames, an even number.
template <class T, std::size_t kMost_>
class FilmOf {
public:
  static constexpr std::size_t kMost = kMost_;
  static constexpr double kFirstInterval = 0.02;  // s; twice as long whenever there would be more

  struct Frame {
    double time = 0;  // s
    T shown;
  };

  explicit FilmOf(double tick_s)
      : ticks_each_(std::max<std::int64_t>(1, std::llround(kFirstInterval / tick_s))) {}

  // time: s of the trial, after that tick; it never goes back.
  void add(const T& shown, double time) {
    if (ticks_++ % ticks_each_ != 0) return;
    if (frames_.size() == kMost) {
      for (std::size_t i = 0; i < kMost / 2; ++i) frames_[i] = frames_[2 * i];
      frames_.resize(kMost / 2);
      ticks_each_ *= 2;
      if ((ticks_ - 1) % ticks_each_ != 0) return;
    }
    frames_.push_back({time, shown});
  }

  bool empty() const { return frames_.empty(); }
  std::size_t frames() const { return frames_.size(); }
  // The last frame that is no later; the first, where all are. Not of an empty film.
  const T& at(double time) const {
    const auto after = std::ranges::upper_bound(frames_, time, {}, &Frame::time);
    return (after == frames_.begin() ? after : after - 1)->shown;
  }
  // All of them, in order.
  std::vector<Frame> take() && { return std::move(frames_); }

private:
  std::int64_t ticks_each_, ticks_ = 0;
  std::vector<Frame> frames_;
};

using Film = FilmOf<TickRecord, 6000>;

}  // namespace fulcrum::app
