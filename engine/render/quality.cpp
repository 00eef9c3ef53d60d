#include "engine/render/quality.h"

#include <algorithm>
#include <utility>

namespace fulcrum::render {
namespace {

constexpr double kWorthwhile = 0.8;  // of the time before: a step down that leaves more is taken back

}  // namespace

bool AutoQuality::add(double frame_s) {
  if (skip_ > 0) {
    --skip_;
    return false;
  }
  times_[count_++] = frame_s;
  if (count_ < kWindow) return false;
  count_ = 0;
  std::array<double, kWindow> sorted = times_;
  std::nth_element(sorted.begin(), sorted.begin() + kWindow / 2, sorted.end());
  const double median = sorted[kWindow / 2];
  const double before = std::exchange(before_s_, 0.0);
  if (before > 0.0 && median > kWorthwhile * before) {
    worst_allowed_ = best_allowed_ = came_from_;
    go_to(came_from_);
    return true;
  }
  if (median > budget_s_ && level_ < worst_allowed_) {
    best_allowed_ = level_ + 1;
    came_from_ = level_;
    before_s_ = median;
    // Each level roughly halves the work: far over the budget, go down by two.
    go_to(std::min(level_ + (median > 3.0 * budget_s_ ? 2 : 1), worst_allowed_));
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
