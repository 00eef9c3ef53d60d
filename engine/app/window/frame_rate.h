#pragma once
// How many frames a second a window draws: of late, for a panel, and over the whole trial, for its summary.
// Time in which nothing could be drawn does not count.

#include <cstdint>

namespace fulcrum::app {

class FrameRate {
public:
  static constexpr double kWindow = 1;  // s, that "of late" is

  // A frame has been drawn; time: s, by a clock that never goes back.
  void note(double time) {
    if (begins_) {
      begins_ = whole_ = false;
      window_ = time;
      of_late_ = 0;
    } else {
      ++intervals_;
      drawing_ += time - last_;
    }
    last_ = time;
    ++of_late_;
    if (time - window_ < kWindow) return;
    newest_ = static_cast<double>(of_late_ - (whole_ ? 0 : 1)) / (time - window_);
    whole_ = true;
    window_ = time;
    of_late_ = 0;
  }

  // Nothing can be drawn from now on, until there is a frame again.
  void rest() { begins_ = true; }

  // 1/s, in the last whole window; 0: none is over.
  double of_late() const { return newest_; }
  // 1/s, since the first frame; 0: there were too few to tell.
  double mean() const { return drawing_ > 0 ? static_cast<double>(intervals_) / drawing_ : 0; }

private:
  std::int64_t intervals_ = 0, of_late_ = 0;
  double drawing_ = 0;            // s, that the intervals took together
  double last_ = 0, window_ = 0;  // s
  double newest_ = 0;
  bool begins_ = true;  // the next frame is the first, or the first after a rest
  bool whole_ = false;  // a window is over: the next one's first frame is the one after it
};

}  // namespace fulcrum::app
