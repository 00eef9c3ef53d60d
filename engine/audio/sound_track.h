#pragma once
// A scene heard without a clock: the same sources, mixed by the same library, tick by tick, into samples.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/audio/output.h"
#include "engine/audio/scene_sound.h"
#include "engine/audio/stage.h"
#include "engine/audio/tick_listener.h"

namespace fulcrum::audio {

class SoundTrack {
public:
  // Errors: the library cannot.
  static Result<std::unique_ptr<SoundTrack>> begin(SceneSound scene, const Listener& listener,
                                                   bool hrtf = true);
  ~SoundTrack();
  SoundTrack(const SoundTrack&) = delete;
  SoundTrack& operator=(const SoundTrack&) = delete;

  // The samples of one more tick: (2 n) interleaved, left first, at kRate_Hz; valid until the next call.
  std::span<const float> tick(const TickRecord& record);
  // At the beginning of the next tick.
  void chime(Chime chime);
  void set_volume(double volume);

  const Stage& stage() const { return *stage_; }

private:
  SoundTrack(Output output, SceneSound scene);

  Output output_;
  SceneSound scene_;
  TickListener listener_;
  std::unique_ptr<Stage> stage_;
  std::int64_t ticks_ = 0;
  std::vector<float> samples_;
};

}  // namespace fulcrum::audio
