#include "engine/scenario/task_judge.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "haptics/math/functions.h"
#include "haptics/safety/faults.h"

namespace fulcrum::scenario {

namespace {

// The least number of ticks that lasts as long; a dwell that is a whole number of ticks, but for rounding, is
// that.
std::int64_t ticks_lasting(double duration, double tick_s) {
  return static_cast<std::int64_t>(std::ceil(duration / tick_s - 1e-6));
}

bool all_reached(const TaskDesc& task, std::span<const std::optional<double>> reached) {
  for (std::size_t i = 0; i < reached.size(); ++i)
    if (!reached[i] && !task.checkpoints[i].optional) return false;
  return true;
}

}  // namespace

std::size_t reached_count(const TaskState& state) {
  return static_cast<std::size_t>(std::ranges::count_if(
      state.reached, [](const std::optional<double>& reached) { return reached.has_value(); }));
}

double shown_progress(const TaskState& state) {
  return state.way < 1 ? state.way : state.dwell_progress;
}

std::vector<bool> open_checkpoints(const TaskDesc& task, std::span<const std::optional<double>> reached) {
  std::vector<bool> open(reached.size(), false);
  if (all_reached(task, reached)) return open;
  if (task.order == Order::given) {
    std::size_t first = reached.size();
    while (first > 0 && !reached[first - 1]) --first;
    for (std::size_t i = first; i < open.size(); ++i) {
      open[i] = true;
      if (!task.checkpoints[i].optional) break;
    }
    return open;
  }
  for (std::size_t i = 0; i < open.size(); ++i) {
    const auto before = std::ranges::find(task.checkpoints, task.checkpoints[i].after, &Checkpoint::name);
    const bool may_be = before == task.checkpoints.end() ||
                        reached[static_cast<std::size_t>(before - task.checkpoints.begin())];
    open[i] = !reached[i] && may_be;
  }
  return open;
}

std::size_t next_checkpoint(const std::vector<bool>& open) {
  return static_cast<std::size_t>(std::ranges::find(open, true) - open.begin());
}

TaskState state_after(const TaskDesc& task, std::vector<std::optional<double>> reached) {
  TaskState state;
  state.reached = std::move(reached);
  state.reached.resize(task.checkpoints.size());
  state.open = open_checkpoints(task, state.reached);
  state.completed = all_reached(task, state.reached);
  state.step = next_checkpoint(state.open);
  if (state.completed) return state;
  const CheckpointWay way(task.checkpoints[state.step]);
  state.place_W = way.place_W();
  state.way = way.done();
  return state;
}

TaskJudge::TaskJudge(TaskDesc desc, double tick_s)
    : desc_(std::move(desc)), tick_s_(tick_s), trespasses_(desc_.avoid.size(), false) {
  for (const Checkpoint& checkpoint : desc_.checkpoints) {
    ways_.emplace_back(checkpoint);
    least_cosines_.push_back(checkpoint.facing ? math::cos(0.5 * checkpoint.facing->within) : 0);
  }
  state_ = state_after(desc_, {});
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

void TaskJudge::judge_trespass(const Vec3& p_WC) {
  bool within = false;
  for (std::size_t i = 0; i < desc_.avoid.size(); ++i) {
    const double distance = (p_WC - desc_.avoid[i].position).norm() / desc_.avoid[i].radius;
    if (distance <= 1 && !trespasses_[i]) ++state_.trespasses;
    within = within || distance <= 1;
    trespasses_[i] = distance <= 1 || (trespasses_[i] && distance <= kOutside);
  }
  if (within) ++trespass_ticks_;
  state_.trespass_time = static_cast<double>(trespass_ticks_) * tick_s_;
}

std::optional<std::size_t> TaskJudge::find_place(const Vec3& p_WC, const TickRecord& record) {
  std::optional<std::size_t> found;
  int worth =
      0;  // of what was found: the most for one that lacks nothing, and more for that of the tick before
  for (std::size_t i = 0; i < ways_.size(); ++i) {
    if (!state_.open[i]) continue;
    const bool there = ways_[i].see(p_WC);
    if (ways_[i].slipped()) ++state_.slips;
    if (!there) continue;
    const int now = 1 + (lack(i, record) == Lack::nothing ? 2 : 0) + (at_ == i ? 1 : 0);
    if (now <= worth) continue;
    worth = now;
    found = i;
  }
  return found;
}

Lack TaskJudge::lack(std::size_t index, const TickRecord& record) const {
  const Checkpoint& checkpoint = desc_.checkpoints[index];
  if (checkpoint.needs == Needs::touch && record.regions <= 0) return Lack::touch;
  if (checkpoint.needs == Needs::stop && !(was_stopped_ && at_ == index)) return Lack::stop;
  if (checkpoint.force) {
    const double force = record.contact_F_T_W.force.norm();
    if (force > checkpoint.force->most) return Lack::less_force;
    if (!(force >= checkpoint.force->least)) return Lack::more_force;
  }
  if (checkpoint.facing) {
    const double cosine = std::abs(record.X_WT.q.dot(checkpoint.facing->q_WT));
    if (!(cosine >= least_cosines_[index])) return Lack::facing;
  }
  return ways_[index].is_too_deep() ? Lack::less_depth : Lack::nothing;
}

void TaskJudge::reach(std::size_t index) {
  state_.reached[index] = state_.time;
  state_.open = open_checkpoints(desc_, state_.reached);
  state_.completed = all_reached(desc_, state_.reached);
  state_.step = next_checkpoint(state_.open);
  state_.inside = false;
  state_.lack = Lack::nothing;
  state_.dwell_progress = 0;
  if (state_.completed) {
    state_.way = 1;
    completed_at_ = state_.time;
  } else {
    state_.place_W = ways_[state_.step].place_W();
    state_.way = ways_[state_.step].done();
  }
  at_.reset();
  ticks_inside_ = -1;
  was_stopped_ = false;
}

void TaskJudge::judge(const TickRecord& record) {
  const Vec3 p_WC = record.X_WT * desc_.touch_point;
  if (record.stopped) {
    // Asked for, by nothing else, and at the checkpoint in the tick in which it began.
    const bool asked_for = (record.faults & kStoppingFaults) == kStopRequested;
    if (!rests_ && asked_for && !state_.completed && ways_[state_.step].holds(p_WC)) {
      was_stopped_ = true;
      at_ = state_.step;
    }
    for (CheckpointWay& way : ways_) way.pause();
    rests_ = true;
    ++rested_;
    return;
  }
  rests_ = false;
  if (desc_.hard_touch) judge_touch(record);
  if (state_.completed) return;
  state_.time = static_cast<double>(record.tick - rested_) * tick_s_;
  if (!desc_.avoid.empty()) judge_trespass(p_WC);

  const std::optional<std::size_t> at = find_place(p_WC, record);
  if (at != at_) {
    if (at_) ways_[*at_].rest();
    ticks_inside_ = -1;
    was_stopped_ = false;
  }
  at_ = at;
  state_.inside = at.has_value();
  state_.step = at.value_or(state_.step);  // who slips off one goes on with that
  const Checkpoint& checkpoint = desc_.checkpoints[state_.step];
  CheckpointWay& way = ways_[state_.step];
  state_.lack = at ? lack(*at, record) : Lack::nothing;
  const bool goes_on = at && state_.lack == Lack::nothing;
  if (goes_on)
    way.go_on(p_WC, record.X_WT.q);
  else
    way.rest();
  state_.place_W = way.place_W();
  state_.way = way.done();
  ticks_inside_ = goes_on && way.is_done() ? ticks_inside_ + 1 : -1;
  const std::int64_t dwell_ticks = ticks_lasting(dwell_of(desc_, checkpoint), tick_s_);
  if (ticks_inside_ >= dwell_ticks) return reach(state_.step);
  state_.dwell_progress =
      ticks_inside_ < 0 ? 0 : static_cast<double>(ticks_inside_) / static_cast<double>(dwell_ticks);
}

std::optional<double> TaskJudge::completion_time() const {
  return completed_at_;
}

}  // namespace fulcrum::scenario
