#include "engine/app/run/sound_file.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/audio/samples.h"

namespace fulcrum::app {

Result<std::unique_ptr<SoundFile>> SoundFile::create(const std::filesystem::path& file,
                                                     const audio::SceneSound& scene,
                                                     const audio::Listener& listener, double volume) {
  Result<std::unique_ptr<audio::SoundTrack>> track = audio::SoundTrack::begin(scene, listener);
  if (!track) return track.error();
  (*track)->set_volume(volume);
  Result<record::WavWriter> writer = record::WavWriter::create(file, audio::kRate_Hz, 2);
  if (!writer) return writer.error();
  return std::unique_ptr<SoundFile>(new SoundFile(std::move(*track), std::move(*writer), scene.tick_s));
}

SoundFile::SoundFile(std::unique_ptr<audio::SoundTrack> track, record::WavWriter writer, double tick_s)
    : track_(std::move(track)),
      writer_(std::move(writer)),
      ticks_a_second_(std::max<std::int64_t>(1, std::llround(1 / tick_s))) {}

void SoundFile::take(const TickRecord& record, const scenario::TaskState& task) {
  last_ = record;
  render(record);
  if (const std::optional<audio::Chime> chime = chimes_.next(task)) track_->chime(*chime);
}

// Brought to the file every second, so that memory stays what it is.
void SoundFile::render(const TickRecord& record) {
  if (error_) return;
  const std::span<const float> samples = track_->tick(record);
  samples_.assign(samples.begin(), samples.end());
  writer_.add(samples_);
  if (++ticks_ % ticks_a_second_ == 0) error_ = writer_.flush();
}

std::optional<Error> SoundFile::close() {
  last_.stopped = true;
  const auto rest = std::llround(kRingsOn * static_cast<double>(ticks_a_second_));
  for (std::int64_t i = 0; i < rest; ++i) {
    ++last_.tick;
    render(last_);
  }
  if (!error_) error_ = writer_.flush();
  if (!error_) error_ = writer_.close();
  return error_;
}

}  // namespace fulcrum::app
