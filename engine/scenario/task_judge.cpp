#include "engine/scenario/task_judge.h"

#include <cmath>
#include <utility>

namespace fulcrum::scenario {

namespace {

// The least number of ticks that lasts as long; a dwell that is a whole number of ticks, but for rounding, is
// that.
std::int64_t ticks_lasting(double duration, double tick_s) {
  return static_cast<std::int64_t>(std::ceil(duration / tick_s - 1e-6));
}

}  // namespace

TaskJudge::TaskJudge(TaskDesc desc, double tick_s)
    : desc_(std::move(desc)), tick_s_(tick_s), dwell_ticks_(ticks_lasting(desc_.dwell, tick_s)) {
  state_.reached.resize(desc_.checkpoints.size());
  state_.completed = desc_.checkpoints.empty();
}

void TaskJudge::judge_touch(const TickRecord& record) {
  const double limit = *desc_.hard_touch;
  // Not a number is no touch: the comparison fails.
  const bool hard = record.contact_F_T_W.force.norm() > (touches_hard_ ? kReleased * limit : limit);
  if (hard && !touches_hard_) ++state_.hard_touches;
  if (hard) ++hard_ticks_;
  touches_hard_ = hard;
  state_.hard_touch_time = static_cast<double>(hard_ticks_) * tick_s_;
}

void TaskJudge::judge(const TickRecord& record) {
  if (record.stopped) {
    ++rested_;
    return;
  }
  if (desc_.hard_touch) judge_touch(record);
  if (state_.completed) return;
  state_.time = static_cast<double>(record.tick - rested_) * tick_s_;
  const Checkpoint& next = desc_.checkpoints[state_.step];
  // Not a number is nowhere: the comparison fails.
  state_.inside = (record.X_WT * desc_.touch_point - next.position).norm() <= next.radius;
  ticks_inside_ = state_.inside ? ticks_inside_ + 1 : -1;
  if (!state_.inside) {
    state_.dwell_progress = 0;
    return;
  }
  if (ticks_inside_ < dwell_ticks_) {
    state_.dwell_progress = static_cast<double>(ticks_inside_) / static_cast<double>(dwell_ticks_);
    return;
  }
  state_.reached[state_.step] = state_.time;
  ++state_.step;
  ticks_inside_ = -1;
  state_.inside = false;
  state_.dwell_progress = 0;
  state_.completed = state_.step == desc_.checkpoints.size();
}

std::optional<double> TaskJudge::completion_time() const {
  if (!state_.completed || state_.reached.empty()) return std::nullopt;
  return state_.reached.back();
}

}  // namespace fulcrum::scenario
