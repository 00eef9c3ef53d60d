#include "engine/audio/samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "haptics/math/functions.h"
#include "haptics/signal/decaying_sine.h"

namespace fulcrum::audio {
namespace {

constexpr double kStep = 1.0 / kRate_Hz;  // s
constexpr double kLastsUntil = 1e-3;      // of the amplitude
constexpr double kSlidePeak = 0.12;       // of full scale
constexpr double kSlidePower = 0.1;       // W, of friction, from which on sliding is no louder
constexpr double kSlideQ = 1.5;           // of its resonance

std::size_t frames(double seconds) {
  return static_cast<std::size_t>(std::llround(seconds * kRate_Hz));
}

const ImpactMaterial& material_of(const SceneSound& scene, std::int32_t object) {
  const auto i = static_cast<std::size_t>(std::max(object, 0));
  return scene.materials[std::min(i, scene.materials.size() - 1)];
}

// Those that can be heard, at the pitch of the scene.
VibrationModes heard_modes(const SceneSound& scene, const Blow& blow) {
  const ImpactMaterial& material = material_of(scene, blow.object);
  const VibrationModes felt =
      vibration_modes(scene.distance, material.frequency_Hz, blow.radius, scene.reach);
  VibrationModes heard;
  for (std::size_t n = 0; n < felt.count; ++n) {
    const double frequency_Hz = scene.pitch * felt.modes[n].frequency_Hz;
    if (frequency_Hz <= kHighest) heard.modes[heard.count++] = {frequency_Hz, felt.modes[n].amplitude};
  }
  return heard;
}

void fade_out(std::span<float> samples) {
  const std::size_t count = std::min(samples.size(), frames(kFade));
  for (std::size_t i = 0; i < count; ++i)
    samples[samples.size() - 1 - i] *= static_cast<float>(i) / static_cast<float>(count);
}

// Adds e^(-d t) sin(2 pi f t) from `at` on.
void add_tone(std::span<float> samples, double at, double frequency_Hz, double decay, double amplitude) {
  DecayingSine sine(frequency_Hz, decay, kStep);
  for (std::size_t i = frames(at); i < samples.size(); ++i)
    samples[i] += static_cast<float>(amplitude * sine.next());
}

// G. Marsaglia, "Xorshift RNGs", J. Statistical Software 8(14), 2003.
class Noise {
public:
  double next() {  // -1 to 1
    state_ ^= state_ << 13;
    state_ ^= state_ >> 17;
    state_ ^= state_ << 5;
    return static_cast<double>(state_) / 2147483648.0 - 1;
  }

private:
  std::uint32_t state_ = 2463534242u;
};

}  // namespace

double struck_level(const SceneSound& scene, const Blow& blow) {
  const double x = material_of(scene, blow.object).attack * blow.speed / kHalf;
  return std::isfinite(x) && x > 0 && std::isfinite(blow.radius) ? scene.gain * kPeak * x / (1 + x) : 0;
}

std::vector<float> struck_samples(const SceneSound& scene, const Blow& blow) {
  const double level = struck_level(scene, blow);
  const VibrationModes modes = heard_modes(scene, blow);
  if (!(level > 0) || modes.count == 0) return {};
  const double decay = material_of(scene, blow.object).decay;
  std::vector<float> samples(frames(std::min(kLongest, -math::log(kLastsUntil) / decay)));
  double sum = 0;
  for (const VibrationModes::Mode& mode : modes.modes) sum += std::abs(mode.amplitude);
  for (std::size_t n = 0; n < modes.count; ++n)
    add_tone(samples, 0, modes.modes[n].frequency_Hz, decay,
             level * modes.modes[n].amplitude / std::max(1.0, sum));
  fade_out(samples);
  return samples;
}

// A resonator of two poles, gone round twice with the same noise: what is left of its beginning by then is
// nothing, and the end goes over into the beginning.
std::vector<float> slide_samples(const SceneSound& scene) {
  const double frequency_Hz = std::min(scene.pitch * material_of(scene, 0).frequency_Hz, kHighest);
  const double kept = math::exp(-std::numbers::pi * frequency_Hz / kSlideQ * kStep);
  const double of_last = 2 * kept * math::cos(2 * std::numbers::pi * frequency_Hz * kStep);
  std::vector<double> noise(frames(kSlideLoop));
  Noise source;
  for (double& each : noise) each = source.next();
  std::vector<double> heard(noise.size());
  double last = 0, before = 0, largest = 0;
  for (int round = 0; round < 2; ++round) {
    largest = 0;
    for (std::size_t i = 0; i < noise.size(); ++i) {
      const double y = noise[i] + of_last * last - kept * kept * before;
      before = last;
      last = y;
      heard[i] = y;
      largest = std::max(largest, std::abs(y));
    }
  }
  std::vector<float> samples(heard.size());
  const double scale = scene.gain * scene.slide * kSlidePeak / largest;
  std::ranges::transform(heard, samples.begin(), [scale](double y) { return static_cast<float>(scale * y); });
  return samples;
}

double slide_level(const Slide& slide) {
  const double power = slide.force * slide.speed;
  return std::isfinite(power) && power > 0 ? std::sqrt(std::min(1.0, power / kSlidePower)) : 0;
}

// Checkpoints go up, and the last of them further; a hard touch is low, rough and short.
std::vector<float> chime_samples(Chime chime) {
  struct Tone {
    double at, frequency_Hz, decay, amplitude;  // s, Hz, 1/s, of full scale
  };
  static constexpr std::array kCheckpoint{Tone{0, 659.26, 12, 0.1}, Tone{0.09, 880, 10, 0.1}};
  static constexpr std::array kCompleted{Tone{0, 659.26, 9, 0.08}, Tone{0.11, 880, 8, 0.08},
                                         Tone{0.22, 1318.5, 6, 0.08}};
  static constexpr std::array kHardTouch{Tone{0, 196, 18, 0.14}, Tone{0, 207.65, 18, 0.14}};
  const std::span<const Tone> tones = chime == Chime::checkpoint  ? std::span<const Tone>(kCheckpoint)
                                      : chime == Chime::completed ? std::span<const Tone>(kCompleted)
                                                                  : std::span<const Tone>(kHardTouch);
  std::vector<float> samples(frames(chime == Chime::hard_touch ? 0.35 : 0.8));
  for (const Tone& tone : tones) add_tone(samples, tone.at, tone.frequency_Hz, tone.decay, tone.amplitude);
  fade_out(samples);
  return samples;
}

}  // namespace fulcrum::audio
