#pragma once
// Judges a run by its ticks, one record after the other: pure, so that a replay gives the verdict of the run.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/scenario/task.h"
#include "haptics/world/tick_record.h"

namespace fulcrum::scenario {

struct TaskState {
  double time = 0;            // s of the trial: rests while the force is stopped, and once all is reached
  std::size_t step = 0;       // the checkpoint that is next; the number of them once completed
  double dwell_progress = 0;  // 0 to 1, of the time to be spent at it
  bool inside = false;        // the touch point was at it in the newest record
  bool lacks = false;         // and what else the checkpoint needs was not there
  std::vector<std::optional<double>> reached;  // (checkpoints) s of the trial at which each one counted
  bool completed = false;
  std::int64_t hard_touches = 0;  // so far, with one that lasts
  double hard_touch_time = 0;     // s above the limit
};

// Checkpoints count in order. One is reached when the touch point has been within its radius in every record
// for the dwell time: that many ticks after the one in which it came in. Leaving starts the count anew; ticks
// that an overrun lost neither count nor break it. Counted in ticks, so that no sum of small times can drift.
// A stop is a pause: until it is acknowledged the trial's time rests and nothing is judged, but that it was
// asked for at a checkpoint that needs it. There the count begins when the force is taken up again. Where a
// checkpoint needs a touch, a tick without one starts the count anew.
class TaskJudge {
public:
  TaskJudge(TaskDesc desc, double tick_s);

  void judge(const TickRecord& record);
  const TaskState& state() const { return state_; }
  std::optional<double> completion_time() const;  // s; absent while not completed

  // A hard touch is over when the force has fallen below this share of the limit: one that trembles about it
  // is one.
  static constexpr double kReleased = 0.7;

private:
  void judge_touch(const TickRecord& record);
  // The touch point is at the checkpoint that is next. Not once completed.
  bool is_there(const TickRecord& record) const;
  bool has_what_it_needs(const TickRecord& record) const;

  TaskDesc desc_;
  double tick_s_;
  std::int64_t dwell_ticks_;
  std::int64_t ticks_inside_ = -1;  // since the touch point came in; -1: it is not inside
  std::int64_t rested_ = 0;         // ticks so far in which the force was stopped
  bool rests_ = false;              // the force was stopped in the newest record
  bool was_stopped_ = false;        // on request, since the touch point came in
  bool touches_hard_ = false;
  std::int64_t hard_ticks_ = 0;
  TaskState state_;
};

}  // namespace fulcrum::scenario
