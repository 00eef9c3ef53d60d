#pragma once
// A level that follows its target no faster than from 0 to 1 in a given time: what fades in and out without a
// click.

#include <algorithm>

namespace fulcrum {

class Ramp {
public:
  // duration: s, from 0 to 1.
  Ramp(double duration, double tick_s) : step_(std::min(1.0, tick_s / duration)) {}

  double towards(double target) noexcept {
    level_ += std::clamp(target - level_, -step_, step_);
    return level_;
  }
  double level() const { return level_; }

private:
  double step_;
  double level_ = 0;
};

}  // namespace fulcrum
