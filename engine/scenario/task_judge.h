#pragma once
// Judges a run by its ticks, one record after the other: pure, so that a replay gives the verdict of the run.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/scenario/checkpoint_way.h"
#include "engine/scenario/task.h"
#include "haptics/world/tick_record.h"

namespace fulcrum::scenario {

// What a checkpoint needs and has not, while the touch point is there.
enum class Lack { nothing, touch, stop, more_force, less_force, facing, less_depth };

struct TaskState {
  double time = 0;              // s of the trial: rests while the force is stopped, and once all is reached
  std::size_t step = 0;         // the checkpoint that is next; the number of them once completed
  Vec3 place_W = Vec3::Zero();  // (3) m, where the touch point is to be for it now
  double way = 1;               // 0 to 1, of what there is to go and to turn at it; 1 where there is nothing
  double dwell_progress = 0;    // 0 to 1, of the time to be spent at it, which begins when its way is done
  bool inside = false;          // the touch point was at it in the newest record
  Lack lack = Lack::nothing;    // and what else the checkpoint needs was not there
  std::vector<std::optional<double>> reached;  // (checkpoints) s of the trial at which each one counted
  std::vector<bool> open;                      // (checkpoints) those of which one may be reached next
  bool completed = false;
  std::int64_t hard_touches = 0;  // so far, with one that lasts
  double hard_touch_time = 0;     // s above the limit
  std::int64_t slips = 0;         // off a line or out of a bore, before its end
  std::int64_t trespasses = 0;    // into what is to be avoided, with one that lasts
  double trespass_time = 0;       // s in it
};

std::size_t reached_count(const TaskState& state);

// Of somebody who has reached these and is at none. reached: (checkpoints); empty: none
TaskState state_after(const TaskDesc& task, std::vector<std::optional<double>> reached);

// 0 to 1, of its way, and once that is done of its dwell.
double shown_progress(const TaskState& state);

// (checkpoints) Those of which one may be reached next. In the order given: all up to the first that is not
// optional, from the last reached one on. In any order: all whose `after` is reached.
std::vector<bool> open_checkpoints(const TaskDesc& task, std::span<const std::optional<double>> reached);

// The first that is open; the number of them where none is.
std::size_t next_checkpoint(const std::vector<bool>& open);

// A checkpoint is reached when the touch point has been at it, and what it needs was so, in every record for
// the dwell time: that many ticks after the one in which all came together. Where there is a way (a line, a
// bore, a turn) the dwell begins at its end, and goes on only as long as what it needs is so. Leaving starts
// the dwell anew; ticks that an overrun lost neither count nor break it. Counted in ticks, so that no sum of
// small times can drift.
// A stop is a pause: until it is acknowledged the trial's time rests and nothing is judged, but that it was
// asked for at a checkpoint that needs it. There the count begins when the force is taken up again.
// The task is completed once all checkpoints are reached that are not optional.
class TaskJudge {
public:
  TaskJudge(TaskDesc desc, double tick_s);

  void judge(const TickRecord& record);
  const TaskState& state() const { return state_; }
  std::optional<double> completion_time() const;  // s; absent while not completed

  // A hard touch is over when the force has fallen below this share of the limit: one that trembles about it
  // is one.
  static constexpr double kReleased = 0.7;
  // And a trespass when the touch point is as many radii away.
  static constexpr double kOutside = 1.1;

private:
  void judge_touch(const TickRecord& record);
  void judge_trespass(const Vec3& p_WC);
  // Of the checkpoints that are open, the one that the touch point is at. Of several one that lacks nothing;
  // of those that of the tick before, else the first. None: it is at none.
  std::optional<std::size_t> find_place(const Vec3& p_WC, const TickRecord& record);
  Lack lack(std::size_t index, const TickRecord& record) const;
  void reach(std::size_t index);

  TaskDesc desc_;
  double tick_s_;
  std::vector<CheckpointWay> ways_;    // (checkpoints)
  std::vector<double> least_cosines_;  // (checkpoints) of half the angle that its facing allows
  std::vector<bool> trespasses_;       // (avoided) it lasts
  std::optional<std::size_t> at_;      // the checkpoint that the touch point was at in the newest record
  std::int64_t ticks_inside_ = -1;     // since all was there; -1: it is not
  std::int64_t rested_ = 0;            // ticks so far in which the force was stopped
  bool rests_ = false;                 // the force was stopped in the newest record
  bool was_stopped_ = false;           // on request, since the touch point came in
  bool touches_hard_ = false;
  std::int64_t hard_ticks_ = 0, trespass_ticks_ = 0;
  std::optional<double> completed_at_;
  TaskState state_;
};

}  // namespace fulcrum::scenario
