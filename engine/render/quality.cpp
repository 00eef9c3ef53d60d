#include "engine/render/quality.h"

#include <algorithm>

namespace fulcrum::render {

bool AutoQuality::add(double frame_s) {
  if (skip_ > 0) {
    --skip_;
    return false;
  }
  times_[count_++] = frame_s;
  if (count_ < kWindow) {
    return false;
  }
  count_ = 0;
  std::array<double, kWindow> sorted = times_;
  std::nth_element(sorted.begin(), sorted.begin() + kWindow / 2, sorted.end());
  const double median = sorted[kWindow / 2];
  if (median > budget_s_ && level_ + 1 < kLevels.size()) {
    best_allowed_ = level_ + 1;
    // Each level roughly halves the work: far over the budget, go down by two.
    go_to(std::min(level_ + (median > 3.0 * budget_s_ ? 2 : 1), kLevels.size() - 1));
    return true;
  }
  if (median < 0.4 * budget_s_ && level_ > best_allowed_) {
    go_to(level_ - 1);
    return true;
  }
  return false;
}

void AutoQuality::go_to(std::size_t level) {
  level_ = level;
  skip_ = 3;
}

}  // namespace fulcrum::render
