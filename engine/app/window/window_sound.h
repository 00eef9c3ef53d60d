#pragma once
// A window's sound: what is played of the attempt that runs, from where the camera is, unless it is muted.

#include "engine/app/cli/run_options.h"
#include "engine/app/run/task_chimes.h"
#include "engine/audio/player.h"
#include "engine/render/visual_desc.h"

namespace fulcrum::app {

class WindowSound {
public:
  // volume: 0 to 1, of what is heard.
  WindowSound(const RunOptions& options, double volume)
      : volume_(options.volume * volume), muted_(options.muted) {}

  // An attempt begins. player: null, and all that follows is silence.
  void begin(audio::Player* player);
  bool is_there() const { return player_ != nullptr; }

  void note(const scenario::TaskState& task);  // after each tick
  void hear_from(const render::Camera& camera);
  void rest();  // the trial has ended; once or more
  void toggle();
  bool is_muted() const { return muted_; }

private:
  void set_volume();

  double volume_;
  bool muted_;
  audio::Player* player_ = nullptr;
  TaskChimes chimes_;
};

}  // namespace fulcrum::app
