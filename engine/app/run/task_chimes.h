#pragma once
// What of a task is to be heard: checkpoints that are reached, and what should not be, as a hard touch is.

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
    const std::int64_t faults = task.hard_touches + task.slips + task.trespasses;
    if (faults > faults_) chime = audio::Chime::hard_touch;
    const std::size_t reached = reached_count(task);
    if (reached > reached_) chime = audio::Chime::checkpoint;
    if (task.completed && !completed_) chime = audio::Chime::completed;
    reached_ = reached;
    faults_ = faults;
    completed_ = task.completed;
    return chime;
  }

private:
  std::size_t reached_ = 0;
  std::int64_t faults_ = 0;
  bool completed_ = false;
};

}  // namespace fulcrum::app
