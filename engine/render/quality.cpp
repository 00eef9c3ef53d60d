#include "engine/render/quality.h"

#include <algorithm>
#include <utility>

namespace fulcrum::render {
namespace {

constexpr double kWorthwhile = 0.8;  // of the time before: a step down that leaves more is taken back

// Where frames take very long, whoever waits for them is helped after a few: that many, once they have taken
// so long together. Whether a step down was worth it is looked at for longer: a machine that is busy with
// something else for a moment would have it taken back for good.
constexpr std::size_t kFew = 3;
constexpr double kLong = 1.0, kLongForJudging = 3.0;  // s

}  // namespace

bool AutoQuality::has_seen_enough() const {
  if (count_ == kWindow) return true;
  return count_ >= kFew && seen_s_ >= (before_s_ > 0.0 ? kLongForJudging : kLong);
}

bool AutoQuality::add(double frame_s) {
  if (skip_ > 0) {
    --skip_;
    return false;
  }
  times_[count_++] = frame_s;
  seen_s_ += frame_s;
  if (!has_seen_enough()) return false;
  std::array<double, kWindow> sorted = times_;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(count_ / 2);
  std::nth_element(sorted.begin(), middle, sorted.begin() + static_cast<std::ptrdiff_t>(count_));
  const double median = *middle;
  count_ = 0;
  seen_s_ = 0;
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
