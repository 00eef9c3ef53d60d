#pragma once
// A curve over a whole trial in bounded memory: the largest value of each of at most kMost intervals, which
// become twice as long whenever there would be more.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace fulcrum::session {

class Envelope {
public:
  static constexpr std::size_t kMost = 1200;

  explicit Envelope(double tick_s) : tick_s_(tick_s) {}

  // One value for each tick; what is no number counts as 0.
  void add(double value) {
    if (filled_ == 0) {
      if (largest_.size() == kMost) halve();
      largest_.push_back(0);
    }
    if (value > largest_.back()) largest_.back() = value;
    filled_ = (filled_ + 1) % ticks_each_;
  }

  const std::vector<double>& largest() const { return largest_; }
  double interval() const { return tick_s_ * static_cast<double>(ticks_each_); }  // s

private:
  void halve() {
    for (std::size_t i = 0; i < kMost / 2; ++i) largest_[i] = std::max(largest_[2 * i], largest_[2 * i + 1]);
    largest_.resize(kMost / 2);
    ticks_each_ *= 2;
  }

  double tick_s_;
  std::int64_t ticks_each_ = 1, filled_ = 0;  // filled_: ticks of the newest interval so far
  std::vector<double> largest_;
};

}  // namespace fulcrum::session
