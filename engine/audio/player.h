#pragma once
// A scene heard while it runs: a thread of its own between the haptic thread, whose ticks it reads from a
// ring, and the sound device. The main thread says from where it is heard, how loud, and what the task sounds
// of. It waits for no frame: a blow is at the library 2 ms after its tick.

#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "engine/audio/output.h"
#include "engine/audio/scene_sound.h"
#include "engine/audio/stage.h"
#include "engine/audio/tick_listener.h"
#include "haptics/loop/timed_tick.h"

namespace fulcrum::audio {

// What was heard so far.
struct PlayedCounts {
  std::int64_t blows = 0;                    // that were played
  std::int64_t dropped = 0;                  // for stronger ones
  std::int64_t late = 0;                     // blows that came too late to be played
  std::int64_t measured = 0;                 // blows whose latency is known
  double latency_sum = 0, latency_most = 0;  // s, from the end of the blow's tick to the loudspeaker
  bool unplugged = false;                    // the device has gone meanwhile
};

class Player {
public:
  static constexpr double kTooLate = 0.15;  // s: a blow that is older is not played

  Player(Output output, SceneSound scene);
  ~Player();  // it falls silent; then the thread ends
  Player(const Player&) = delete;
  Player& operator=(const Player&) = delete;

  // For LiveLoop::also_tell().
  TimedTicks& ticks() { return ticks_; }

  // The main thread.
  void hear_from(const Listener& listener);
  void set_volume(double volume);  // 0 to 1
  void chime(Chime chime);
  void rest();  // the trial has ended: nothing more begins, and sliding falls silent
  PlayedCounts counts() const;
  std::string device() const { return output_.name() + (output_.has_hrtf() ? ", HRTF" : ""); }

private:
  // What the main thread has told and the sound thread has not done yet.
  struct Told {
    Listener listener;
    double volume = 1;
    std::vector<Chime> chimes;
    bool rests = false, ends = false;
  };
  struct Measured {
    Stage::Started started;
    std::int64_t at_ns = 0;  // of its tick
  };

  void play_on();
  void hear(Stage& stage, bool rests);
  void measure(const Stage& stage);

  Output output_;
  SceneSound scene_;
  TimedTicks ticks_;
  TickListener listener_;             // the thread's own
  std::vector<Measured> unmeasured_;  // the thread's own
  mutable std::mutex mutex_;          // of the two below; never the haptic thread's
  Told told_;
  PlayedCounts counts_;
  std::thread thread_;
};

}  // namespace fulcrum::audio
