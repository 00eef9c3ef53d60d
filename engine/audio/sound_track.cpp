#include "engine/audio/sound_track.h"

#include <cmath>
#include <memory>
#include <utility>

namespace fulcrum::audio {

Result<std::unique_ptr<SoundTrack>> SoundTrack::begin(SceneSound scene, const Listener& listener, bool hrtf) {
  Result<Output> output = Output::offline(hrtf);
  if (!output) return output.error();
  std::unique_ptr<SoundTrack> self(new SoundTrack(std::move(*output), std::move(scene)));
  self->stage_->hear_from(listener);
  return self;
}

SoundTrack::SoundTrack(Output output, SceneSound scene)
    : output_(std::move(output)), scene_(std::move(scene)), listener_(scene_) {
  output_.use();
  stage_ = std::make_unique<Stage>(scene_);
}

SoundTrack::~SoundTrack() {
  output_.use();
  stage_.reset();
  Output::let_go();
}

void SoundTrack::chime(Chime chime) {
  output_.use();
  stage_->chime(chime);
}

void SoundTrack::set_volume(double volume) {
  output_.use();
  stage_->set_volume(volume);
}

// A tick need not be a whole number of samples: counted from the beginning, so that none is lost.
std::span<const float> SoundTrack::tick(const TickRecord& record) {
  output_.use();
  const Heard heard = listener_.next(record);
  if (heard.blow) stage_->strike(*heard.blow);
  stage_->slide(heard.slide);
  stage_->turn(scene_.tick_s);
  const auto before = std::llround(static_cast<double>(ticks_) * scene_.tick_s * kRate_Hz);
  const auto after = std::llround(static_cast<double>(++ticks_) * scene_.tick_s * kRate_Hz);
  samples_.resize(2 * static_cast<std::size_t>(after - before));
  output_.render(samples_);
  return samples_;
}

}  // namespace fulcrum::audio
