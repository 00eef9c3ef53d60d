// A tone of 200 Hz on a device that holds each sample for a tick.

#include <cmath>
#include <complex>
#include <numbers>

#include "engine/analysis/best_time.h"
#include "engine/analysis/workprecision/workprecision.h"
#include "haptics/math/functions.h"
#include "haptics/signal/held_sine.h"

namespace fulcrum::analysis::workprecision {
namespace {

constexpr double kTone_Hz = 200;

// Of the staircase that holds each sample, at the tone's frequency.
double held_amplitude(const std::vector<double>& samples, double tick_s) {
  const double w = 2 * std::numbers::pi * kTone_Hz;
  const auto turned = [w](double t) { return std::complex(math::cos(w * t), -math::sin(w * t)); };
  std::complex<double> sum = 0;
  for (std::size_t n = 0; n < samples.size(); ++n) {
    const double t = static_cast<double>(n) * tick_s;
    sum += samples[n] * (turned(t) - turned(t + tick_s)) / std::complex(0.0, w);
  }
  return 2 * std::sqrt(std::norm(sum)) / (static_cast<double>(samples.size()) * tick_s);
}

}  // namespace

WorkStudy study_tone(bool quick) {
  WorkStudy study{
      "held tone",
      "A vibration of 200 Hz and amplitude 1 on a device that holds each sample for a tick. As sampled: "
      "sin(2 pi f t), of which sinc(f T) is left. Held: larger by its inverse, as the vibration of torque "
      "substitution is made. The error is that of the amplitude at 200 Hz of what is held, by its Fourier "
      "integral over a second; the work is a second of samples.",
      "tick (ms)",
      "",
      {{"as sampled", 2}},
      {}};
  const std::vector<double> ticks_ms =
      quick ? std::vector{1.0, 0.5} : std::vector{2.0, 1.0, 0.5, 0.25, 0.1, 0.05};
  for (const bool held : {false, true}) {
    for (const double tick_ms : ticks_ms) {
      const double tick_s = 1e-3 * tick_ms;
      std::vector<double> samples(static_cast<std::size_t>(std::lround(1 / tick_s)));
      const double cpu_us = best_us([&] {
        HeldSine sine(kTone_Hz, tick_s);
        const double part = held ? 1.0 : 1.0 / sine.largest();
        for (double& sample : samples) sample = part * sine.next();
      });
      study.points.push_back(
          {held ? "held" : "as sampled", tick_ms, std::abs(held_amplitude(samples, tick_s) - 1.0), cpu_us});
    }
  }
  measure_orders(study);
  return study;
}

}  // namespace fulcrum::analysis::workprecision
