#include "engine/scenario/task_judge.h"

#include <cmath>
#include <utility>

#include "haptics/safety/faults.h"

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
  const double force = record.contact_F_T_W.force.norm();
  const bool above = force > limit;
  if (above && !touches_hard_) ++state_.hard_touches;
  if (above) ++hard_ticks_;
  touches_hard_ = above || (touches_hard_ && force > kReleased * limit);
  state_.hard_touch_time = static_cast<double>(hard_ticks_) * tick_s_;
}

bool TaskJudge::is_there(const TickRecord& record) const {
  const Checkpoint& next = desc_.checkpoints[state_.step];
  // Not a number is nowhere: the comparison fails.
  return (record.X_WT * desc_.touch_point - next.position).norm() <= next.radius;
}

bool TaskJudge::has_what_it_needs(const TickRecord& record) const {
  switch (desc_.checkpoints[state_.step].needs) {
    case Needs::place:
      return true;
    case Needs::touch:
      return record.regions > 0;
    case Needs::stop:
      return was_stopped_;
  }
  return true;
}

void TaskJudge::judge(const TickRecord& record) {
  if (record.stopped) {
    // Asked for, by nothing else, and at the checkpoint in the tick in which it began.
    const bool asked_for = (record.faults & kStoppingFaults) == kStopRequested;
    if (!rests_ && asked_for && !state_.completed && is_there(record)) was_stopped_ = true;
    rests_ = true;
    ++rested_;
    return;
  }
  rests_ = false;
  if (desc_.hard_touch) judge_touch(record);
  if (state_.completed) return;
  state_.time = static_cast<double>(record.tick - rested_) * tick_s_;
  state_.inside = is_there(record);
  if (!state_.inside) was_stopped_ = false;
  state_.lacks = state_.inside && !has_what_it_needs(record);
  const bool counts = state_.inside && !state_.lacks;
  ticks_inside_ = counts ? ticks_inside_ + 1 : -1;
  if (!counts) {
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
  was_stopped_ = false;
  state_.inside = false;
  state_.dwell_progress = 0;
  state_.completed = state_.step == desc_.checkpoints.size();
}

std::optional<double> TaskJudge::completion_time() const {
  if (!state_.completed || state_.reached.empty()) return std::nullopt;
  return state_.reached.back();
}

}  // namespace fulcrum::scenario
