#pragma once
// What a run without a window would have sounded like: sound.wav, stereo, mixed by OpenAL Soft without a
// device.

#include <filesystem>
#include <memory>
#include <optional>

#include "engine/app/run/task_chimes.h"
#include "engine/audio/sound_track.h"
#include "engine/record/wav_writer.h"

namespace fulcrum::app {

class SoundFile {
public:
  static constexpr double kRingsOn = 1.5;  // s, after the last tick

  static Result<std::unique_ptr<SoundFile>> create(const std::filesystem::path& file,
                                                   const audio::SceneSound& scene,
                                                   const audio::Listener& listener, double volume);

  // Every tick, in order.
  void take(const TickRecord& record, const scenario::TaskState& task);
  // What rings on at the end is in the file, too. Errors: of the file, of any tick.
  std::optional<Error> close();

private:
  SoundFile(std::unique_ptr<audio::SoundTrack> track, record::WavWriter writer, double tick_s);
  void render(const TickRecord& record);

  std::unique_ptr<audio::SoundTrack> track_;
  record::WavWriter writer_;
  std::int64_t ticks_a_second_;
  std::int64_t ticks_ = 0;
  TickRecord last_;
  TaskChimes chimes_;
  std::vector<double> samples_;
  std::optional<Error> error_;
};

}  // namespace fulcrum::app
