#define AL_ALEXT_PROTOTYPES
#include "engine/audio/stage.h"

#include <AL/al.h>
#include <AL/alext.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "haptics/math/functions.h"

namespace fulcrum::audio {
namespace {

constexpr double kSlideFollows = 0.02;  // s, in which the loudness of sliding follows
constexpr double kSlideSilent = 1e-3;   // of full; below it the source rests

void place(ALuint source, const Vec3& p_W) {
  alSource3f(source, AL_POSITION, static_cast<ALfloat>(p_W.x()), static_cast<ALfloat>(p_W.y()),
             static_cast<ALfloat>(p_W.z()));
}

void fill(ALuint buffer, const std::vector<float>& samples) {
  alBufferData(buffer, AL_FORMAT_MONO_FLOAT32, samples.data(),
               static_cast<ALsizei>(samples.size() * sizeof(float)), kRate_Hz);
}

}  // namespace

Stage::Stage(const SceneSound& scene) : scene_(scene), voices_(kSources) {
  alDistanceModel(AL_INVERSE_DISTANCE_CLAMPED);
  const auto make = [](ALuint& source, ALuint& buffer) {
    alGenSources(1, &source);
    alGenBuffers(1, &buffer);
    alSourcef(source, AL_REFERENCE_DISTANCE, static_cast<ALfloat>(kReference));
  };
  for (Voice& voice : voices_) make(voice.source, voice.buffer);
  if (scene.slide == 0 || scene.gain == 0) return;
  make(slide_source_, slide_buffer_);
  fill(slide_buffer_, slide_samples(scene));
  alSourcei(slide_source_, AL_BUFFER, static_cast<ALint>(slide_buffer_));
  alSourcei(slide_source_, AL_LOOPING, AL_TRUE);
  alSourcef(slide_source_, AL_GAIN, 0);
}

Stage::~Stage() {
  for (Voice& voice : voices_) {
    alDeleteSources(1, &voice.source);
    alDeleteBuffers(1, &voice.buffer);
  }
  if (slide_source_ == 0) return;
  alDeleteSources(1, &slide_source_);
  alDeleteBuffers(1, &slide_buffer_);
}

void Stage::hear_from(const Listener& listener) {
  if (!listener.p_W.allFinite() || !listener.ahead_W.allFinite() || !listener.up_W.allFinite()) return;
  const Eigen::Vector3f p = listener.p_W.cast<float>(), ahead = listener.ahead_W.cast<float>(),
                        up = listener.up_W.cast<float>();
  alListener3f(AL_POSITION, p.x(), p.y(), p.z());
  const std::array<ALfloat, 6> turned{ahead.x(), ahead.y(), ahead.z(), up.x(), up.y(), up.z()};
  alListenerfv(AL_ORIENTATION, turned.data());
}

void Stage::set_volume(double volume) {
  alListenerf(AL_GAIN, std::isfinite(volume) ? static_cast<ALfloat>(std::clamp(volume, 0.0, 1.0)) : 0);
}

std::optional<Stage::Started> Stage::strike(const Blow& blow) {
  if (!blow.p_W.allFinite()) return std::nullopt;
  const auto object = static_cast<std::size_t>(std::max(blow.object, 0));
  return play(struck_samples(scene_, blow), struck_level(scene_, blow),
              scene_.materials[std::min(object, scene_.materials.size() - 1)].decay, &blow.p_W);
}

void Stage::chime(Chime chime) {
  play(chime_samples(chime), kPeak, 8, nullptr);
}

std::optional<std::size_t> Stage::room_for(double level) {
  const auto free = std::ranges::find_if(voices_, [](const Voice& voice) { return !voice.sounds; });
  if (free == voices_.end()) return std::nullopt;
  if (sounding() < kSounding) return free - voices_.begin();
  Voice* weakest = nullptr;
  for (Voice& voice : voices_)
    if (voice.sounds && voice.fades == 0 && (weakest == nullptr || voice.level < weakest->level))
      weakest = &voice;
  if (weakest == nullptr || weakest->level >= level) return std::nullopt;
  weakest->fades = kFadeOut;
  alSourcef(weakest->source, AL_GAIN, 0);  // the library goes there over its period
  ++dropped_;
  return free - voices_.begin();
}

std::optional<Stage::Started> Stage::play(const std::vector<float>& samples, double level, double decay,
                                          const Vec3* p_W) {
  if (samples.empty()) return std::nullopt;
  const std::optional<std::size_t> at = room_for(level);
  if (!at) {
    ++dropped_;
    return std::nullopt;
  }
  Voice& voice = voices_[*at];
  voice.level = level;
  voice.decay = decay;
  voice.fades = 0;
  voice.sounds = true;
  voice.number = ++started_;
  alSourcei(voice.source, AL_BUFFER, 0);
  fill(voice.buffer, samples);
  alSourcei(voice.source, AL_BUFFER, static_cast<ALint>(voice.buffer));
  alSourcei(voice.source, AL_SOURCE_RELATIVE, p_W == nullptr ? AL_TRUE : AL_FALSE);
  place(voice.source, p_W == nullptr ? Vec3(Vec3::Zero()) : *p_W);
  alSourcef(voice.source, AL_GAIN, 1);
  alSourcePlay(voice.source);
  return Started{*at, voice.number};
}

void Stage::slide(const std::optional<Slide>& slide) {
  slide_gain_ = slide && slide->p_W.allFinite() ? slide_level(*slide) : 0;
  if (slide_source_ != 0 && slide_gain_ > 0) place(slide_source_, slide->p_W);
}

void Stage::turn(double seconds) {
  for (Voice& voice : voices_) {
    if (!voice.sounds) continue;
    voice.level *= math::exp(-voice.decay * seconds);
    ALint state = AL_STOPPED;
    alGetSourcei(voice.source, AL_SOURCE_STATE, &state);
    if (voice.fades > 0) {
      voice.fades -= seconds;
      if (voice.fades <= 0) alSourceStop(voice.source);
      voice.sounds = voice.fades > 0;
    } else {
      voice.sounds = state == AL_PLAYING;
    }
  }
  if (slide_source_ == 0) return;
  ALfloat gain = 0;
  alGetSourcef(slide_source_, AL_GAIN, &gain);
  const double part = 1 - math::exp(-seconds / kSlideFollows);
  double wanted = static_cast<double>(gain) + part * (slide_gain_ - static_cast<double>(gain));
  if (slide_gain_ == 0 && wanted < kSlideSilent) wanted = 0;
  if (wanted > 0 && !slides_) alSourcePlay(slide_source_);
  if (wanted == 0 && gain == 0 && slides_) alSourcePause(slide_source_);
  slides_ = wanted > 0 || gain > 0;
  alSourcef(slide_source_, AL_GAIN, static_cast<ALfloat>(wanted));
}

std::size_t Stage::sounding() const {
  return static_cast<std::size_t>(std::ranges::count_if(
      voices_, [](const Voice& voice) { return voice.sounds && voice.fades == 0; }));
}

std::optional<double> Stage::heard_after(const Started& started) const {
  const Voice& voice = voices_[started.voice];
  if (voice.number != started.number) return std::nullopt;
  std::array<ALint64SOFT, 2> told{};  // 32.32 samples that are mixed, and ns until the last of them is heard
  alGetSourcei64vSOFT(voice.source, AL_SAMPLE_OFFSET_LATENCY_SOFT, told.data());
  if (told[0] <= 0) return std::nullopt;
  return 1e-9 * static_cast<double>(told[1]) - static_cast<double>(told[0]) / 4294967296.0 / kRate_Hz;
}

}  // namespace fulcrum::audio
