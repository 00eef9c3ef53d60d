#pragma once
// Vibrations that sound together, of which there are only so many. One more drops the weakest, the one with
// the least energy left,
//     (|F|^2 + |tau|^2 / l^2) sum_n a_n^2 e^(-2 d t) / 4 d,   l = 0.12 m
// be it an old one or the new one; what was dropped is counted. A voice ends by itself when a millionth of
// its energy is left, when it is a thousandth as strong: 1.4 s at a decay of 5 1/s.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "haptics/effects/impact_vibration/distance_model.h"
#include "haptics/math/wrench.h"
#include "haptics/signal/decaying_sine.h"

namespace fulcrum {

inline constexpr double kEqualLever = 0.12;  // m, l: at this distance a force counts as much as its moment

class ImpactVoices {
public:
  static constexpr std::size_t kMax = 16;

  ImpactVoices(std::size_t limit, double tick_s) : limit_(limit), tick_s_(tick_s) {}  // limit: 1 to kMax

  // Sounds from the next call of next() on; false: it was the weakest, and is dropped. amplitude: of a mode
  // of amplitude 1. decay: 1/s, above 0.
  bool start(const Wrench& amplitude, const VibrationModes& modes, double decay) noexcept;
  // The sum of one tick.
  Wrench next() noexcept;

  std::size_t sounding() const { return count_; }
  std::int64_t dropped() const { return dropped_; }

private:
  struct Voice {
    Wrench amplitude;
    std::array<DecayingSine, VibrationModes::kMax> sines;
    std::array<double, VibrationModes::kMax> weights{};
    double energy = 0;  // left
    double kept = 0;    // of the energy, each tick
    double least = 0;   // energy at which it ends
  };

  std::size_t limit_;
  double tick_s_;
  std::array<Voice, kMax> voices_{};
  std::size_t count_ = 0;
  std::int64_t dropped_ = 0;
};

}  // namespace fulcrum
