// A trembling hand on a wall, through encoders that count: how far below the truth the passivity observer
// reads.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/analysis/best_time.h"
#include "engine/analysis/workprecision/workprecision.h"
#include "haptics/math/functions.h"
#include "haptics/math/split_mix.h"
#include "haptics/safety/passivity_observer.h"

namespace fulcrum::analysis::workprecision {
namespace {

constexpr double kTick = 1e-3;          // s
constexpr double kSpring = 2000;        // N/m
constexpr double kDamping = 4;          // N s/m
constexpr double kCutoff_Hz = 60;       // of the wall's velocity
constexpr double kDepth = 2e-3;         // m, of the press
constexpr double kLow = 8, kHigh = 12;  // Hz, of tremor
constexpr int kTones = 6;

// What each tick counts, and the force that the wall then holds.
struct Trembling {
  std::vector<double> counted, force;  // m, N
  double first_force = 0;              // N
  double truth = 0;                    // J, of the hand at the end
};

Trembling tremble(double rms, double count, double seconds) {
  struct Tone {
    double w, phase;
  };
  SplitMix random(1);
  std::vector<Tone> tones;
  for (int i = 0; i < kTones; ++i)
    tones.push_back({2 * std::numbers::pi * (kLow + (kHigh - kLow) * random.uniform()),
                     2 * std::numbers::pi * random.uniform()});
  const auto place = [&](int tick) {
    double x = kDepth;
    for (const Tone& tone : tones)
      x += rms * std::sqrt(2.0 / kTones) * math::sin(tone.w * tick * kTick + tone.phase);
    return x;
  };
  const auto seen = [count](double x) { return count > 0 ? std::round(x / count) * count : x; };
  const double keep = math::exp(-2 * std::numbers::pi * kCutoff_Hz * kTick);
  Trembling hand;
  double x = place(0), q = seen(x), v = 0, F = -kSpring * q;
  hand.first_force = F;
  for (int tick = 1; tick <= static_cast<int>(seconds / kTick); ++tick) {
    const double next = place(tick);
    hand.truth -= F * (next - x);
    hand.counted.push_back(seen(next) - q);
    x = next;
    q = seen(next);
    v = keep * v + (1 - keep) * hand.counted.back() / kTick;
    F = -kSpring * q - kDamping * v;
    hand.force.push_back(F);
  }
  return hand;
}

double by_whole_counts(const Trembling& hand) {
  double work = 0, F = hand.first_force;
  for (std::size_t tick = 0; tick < hand.counted.size(); ++tick) {
    work -= F * hand.counted[tick];
    F = hand.force[tick];
  }
  return work;
}

double by_observer(const Trembling& hand, double count) {
  Vec6 steps = Vec6::Zero(), d = Vec6::Zero();
  steps[0] = count;
  PassivityObserver observer(steps, true, false);
  PassivityObserver::Port port;
  port.open = true;
  port.F_H_D.force.x() = hand.first_force;
  observer.update(d, port);
  for (std::size_t tick = 0; tick < hand.counted.size(); ++tick) {
    d[0] = hand.counted[tick];
    port.F_H_D.force.x() = hand.force[tick];
    observer.update(d, port);
  }
  return observer.port();
}

}  // namespace

WorkStudy study_port(bool quick) {
  const double seconds = quick ? 6 : 24;
  WorkStudy study{"port energy",
                  "A hand that trembles, 8 to 12 Hz and as much rms as the method says, 2 mm deep in a wall "
                  "of 2000 N/m and 4 N s/m, "
                  "for 24 s at 1 kHz. The truth is the work of the held force on the way that the handle "
                  "really goes. The error is how "
                  "far the port reads from it at the end: 'least' is the passivity observer, always below "
                  "the truth; 'whole counts' "
                  "books each count against the force that was held when it came. The work is all 24 s.",
                  "count (um)",
                  "mJ",
                  {},
                  {}};
  const std::vector<double> counts_um =
      quick ? std::vector{100.0, 28.0} : std::vector{300.0, 100.0, 28.0, 10.0, 2.0, 0.5};
  for (const double rms_um : {20.0, 50.0, 150.0}) {
    for (const bool least : {true, false}) {
      if (!least && rms_um < 150) continue;
      for (const double count_um : counts_um) {
        const double count = 1e-6 * count_um;
        const Trembling hand = tremble(1e-6 * rms_um, count, seconds);
        double port = 0;
        const double cpu_us =
            best_us([&] { port = least ? by_observer(hand, count) : by_whole_counts(hand); });
        const std::string method =
            (least ? "least, " : "whole counts, ") + std::to_string(std::lround(rms_um)) + " um";
        study.points.push_back({method, count_um, 1e3 * std::abs(hand.truth - port), cpu_us});
      }
    }
  }
  measure_orders(study);
  return study;
}

}  // namespace fulcrum::analysis::workprecision
