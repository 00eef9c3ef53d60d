#pragma once
// How long frames take, in the median.

#include <cstddef>
#include <functional>
#include <vector>

#include "haptics/math/result.h"

namespace fulcrum::analysis::picture {

// How long frames take at quality levels that are drawn by turns. The first rounds do not count: drivers
// compile shaders while drawing those, and a graphics card that had nothing to do runs at a lower clock until
// it has been busy for a while.
class FrameTimes {
public:
  explicit FrameTimes(std::size_t levels) : times_(levels) {}

  // Lets the levels take turns, frame by frame, until there are enough: what else the machine does meanwhile
  // slows all of them alike. draw: draws the next frame of a level; s that it took.
  static Result<FrameTimes> by_turns(std::size_t levels,
                                     const std::function<Result<double>(std::size_t)>& draw);

  // Of the next frame, level after level.
  void add(double frame_s);
  // A whole number of rounds, and enough of them for a median.
  bool are_enough() const;
  double median_ms(std::size_t level) const;

private:
  static constexpr std::size_t kUncounted = 3, kRounds = 9;       // at least
  static constexpr double kUncounted_s = 0.25, kCounted_s = 0.5;  // and so long in all

  std::vector<std::vector<double>> times_;  // s, of the rounds that count
  std::size_t next_ = 0;                    // level
  std::size_t rounds_ = 0;                  // that are over
  bool counts_ = false;                     // this one
  double uncounted_s_ = 0, counted_s_ = 0;
};

}  // namespace fulcrum::analysis::picture
