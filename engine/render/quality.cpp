#include "engine/render/quality.h"

#include <algorithm>
#include <utility>

namespace fulcrum::render {
namespace {

constexpr double kLittle = 0.8;  // of the time before: a step that leaves more changes little
constexpr double kOver = 1.2;    // of the budget: what takes longer is left, so that nothing swings about it
constexpr double kFar = 3.0;     // budgets: twice as far down, and no better level is tried

// Where frames take very long, whoever waits for them is helped after a few: that many, once they have taken
// so long together. Whether a step was worth it is looked at for longer: a machine that is busy with
// something else for a moment would have it taken back.
constexpr std::size_t kFew = 3;
constexpr double kLong = 0.5, kLongForJudging = 2.0;  // s

constexpr double kLongestPause = 160.0;  // s
constexpr double kOther = 1.5;           // times as long as when a limit was found: it holds no longer

}  // namespace

bool AutoQuality::has_seen_enough() const {
  if (count_ == kWindow) return true;
  return count_ >= kFew && seen_s_ >= (judged_ == Step::none ? kLong : kLongForJudging);
}

double AutoQuality::take_median() {
  const auto middle = times_.begin() + static_cast<std::ptrdiff_t>(count_ / 2);
  std::nth_element(times_.begin(), middle, times_.begin() + static_cast<std::ptrdiff_t>(count_));
  count_ = 0;
  seen_s_ = 0.0;
  return *middle;
}

bool AutoQuality::keeps_step(double median) {
  const Step step = std::exchange(judged_, Step::none);
  // What a climb beyond the budget costs is compared with where it left that, not with the step before:
  // four steps of a quarter each would make more than twice as much.
  const double left_s = beyond_s_ > 0 ? beyond_s_ : before_s_;
  if (step == Step::up && median > budget_s_ && kLittle * median > left_s) {
    best_allowed_ = came_from_;
    go_to(came_from_, Step::none, median);
    return false;
  }
  if (step == Step::down && median > kLittle * before_s_) {
    worst_allowed_ = best_allowed_ = came_from_;
    learnt_s_ = before_s_;
    beyond_s_ = median;
    go_to(came_from_, Step::none, median);
    return false;
  }
  if (step == Step::up && median > budget_s_) {
    beyond_s_ = left_s;
    worst_allowed_ = level_;
    learnt_s_ = median;
  } else if (step != Step::none || median <= budget_s_) {
    beyond_s_ = 0;
  }
  return true;
}

bool AutoQuality::add(double frame_s) {
  since_s_ += frame_s;
  if (skip_ > 0) {
    --skip_;
    return false;
  }
  times_[count_++] = frame_s;
  seen_s_ += frame_s;
  if (!has_seen_enough()) return false;
  const double median = take_median();
  if (!keeps_step(median)) return true;
  if (since_s_ > pause_s_ && (best_allowed_ > best_possible_ || worst_allowed_ < kLowest)) {
    best_allowed_ = best_possible_;
    worst_allowed_ = kLowest;
    since_s_ = 0.0;
    pause_s_ = std::min(2.0 * pause_s_, kLongestPause);
  }
  if (median > kOther * learnt_s_) {  // what was learnt was of another view
    worst_allowed_ = kLowest;
    beyond_s_ = 0;
  }
  if (median > kOver * budget_s_ && level_ < worst_allowed_) {
    best_allowed_ = level_ + 1;
    go_to(std::min(level_ + (median > kFar * budget_s_ ? 2 : 1), worst_allowed_), Step::down, median);
    return true;
  }
  if (median < kFar * budget_s_ && level_ > best_allowed_) {
    go_to(level_ - 1, Step::up, median);
    return true;
  }
  return false;
}

bool AutoQuality::refuse() {
  if (level_ == kLowest) return false;
  best_possible_ = level_ + 1;
  best_allowed_ = std::max(best_allowed_, best_possible_);
  worst_allowed_ = std::max(worst_allowed_, best_possible_);
  go_to(best_possible_, Step::none, before_s_);
  return true;
}

void AutoQuality::go_to(std::size_t level, Step step, double median) {
  if (step != Step::up) since_s_ = 0.0;
  came_from_ = std::exchange(level_, level);
  before_s_ = median;
  judged_ = step;
  skip_ = kUncounted;
}

}  // namespace fulcrum::render
