#pragma once
// The largest of the last moments: held, then falling.

#include <algorithm>
#include <cmath>

namespace fulcrum::ui {

class PeakHold {
public:
  // A value at a time (s); returns the peak to show. Time that runs backwards starts anew.
  double add(double value, double time_s) {
    const double since_s = time_s - last_s_;
    if (value >= peak_ || since_s < 0.0) {
      peak_ = value;
      held_until_s_ = time_s + kHold_s;
    } else if (time_s > held_until_s_) {
      peak_ = std::max(value, peak_ * std::exp(-since_s / kFall_s));
    }
    last_s_ = time_s;
    return peak_;
  }

private:
  static constexpr double kHold_s = 1.5;
  static constexpr double kFall_s = 0.4;

  double peak_ = 0.0;
  double held_until_s_ = 0.0;
  double last_s_ = 0.0;
};

}  // namespace fulcrum::ui
