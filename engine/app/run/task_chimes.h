#pragma once
// What of a task is to be heard: checkpoints that are reached, and touches that are too hard.

#include <cstddef>
#include <cstdint>
#include <optional>

#include "engine/audio/scene_sound.h"
#include "engine/scenario/task_judge.h"

namespace fulcrum::app {

class TaskChimes {
public:
  // The state after a tick; what happened since the one before. Of several things, that which says most: the
  // end, then a checkpoint.
  std::optional<audio::Chime> next(const scenario::TaskState& task) {
    std::optional<audio::Chime> chime;
    if (task.hard_touches > hard_touches_) chime = audio::Chime::hard_touch;
    if (task.step > step_) chime = audio::Chime::checkpoint;
    if (task.completed && !completed_) chime = audio::Chime::completed;
    step_ = task.step;
    hard_touches_ = task.hard_touches;
    completed_ = task.completed;
    return chime;
  }

private:
  std::size_t step_ = 0;
  std::int64_t hard_touches_ = 0;
  bool completed_ = false;
};

}  // namespace fulcrum::app
