#include "haptics/effects/impact_vibration/impact_voices.h"

#include <algorithm>
#include <functional>

#include "haptics/math/functions.h"

namespace fulcrum {
namespace {

constexpr double kNegligible = 1e-6;  // of a voice's energy

}  // namespace

bool ImpactVoices::start(const Wrench& amplitude, const VibrationModes& modes, double decay) noexcept {
  Voice voice;
  voice.amplitude = amplitude;
  double squares = 0;
  for (std::size_t n = 0; n < modes.count; ++n) {
    voice.sines[n] = {modes.modes[n].frequency_Hz, decay, tick_s_};
    voice.weights[n] = modes.modes[n].amplitude;
    squares += voice.weights[n] * voice.weights[n];
  }
  voice.energy =
      (amplitude.force.squaredNorm() + amplitude.torque.squaredNorm() / (kEqualLever * kEqualLever)) *
      squares / (4 * decay);
  voice.kept = math::exp(-2 * decay * tick_s_);
  voice.least = kNegligible * voice.energy;
  if (count_ < limit_) {
    voices_[count_++] = voice;
    return true;
  }
  ++dropped_;
  const auto end = voices_.begin() + static_cast<std::ptrdiff_t>(count_);
  const auto weakest = std::ranges::min_element(voices_.begin(), end, std::less<>(), &Voice::energy);
  if (weakest->energy >= voice.energy) return false;
  *weakest = voice;
  return true;
}

Wrench ImpactVoices::next() noexcept {
  Wrench sum;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    Voice& voice = voices_[i];
    double level = 0;
    for (std::size_t n = 0; n < VibrationModes::kMax; ++n) level += voice.weights[n] * voice.sines[n].next();
    sum += voice.amplitude * level;
    voice.energy *= voice.kept;
    if (voice.energy > voice.least) voices_[kept++] = voice;
  }
  count_ = kept;
  return sum;
}

}  // namespace fulcrum
