#include "engine/analysis/stability/passivity.h"

#include <algorithm>
#include <limits>
#include <numbers>

#include "haptics/math/functions.h"

namespace fulcrum::analysis::stability {

double passive_stiffness_limit(const WallLoop& loop, double B) {
  const double b = loop.axis.damping, T = loop.tick_s, n = loop.delay_ticks;
  if (B > b) return 0;  // at wT = pi / (n + 1) the condition is b > K T/2 + B
  // For each frequency the condition is a bound on K, from above where the spring's factor is positive. From
  // below it asks for less than 0 while B <= b.
  const auto bound = [&](double wT) {
    const double factor = wT > 1e-9 ? math::sin((n + 0.5) * wT) / math::sin(0.5 * wT) : 2 * n + 1;
    return factor > 0 ? 2 * (b + B * math::cos((n + 1) * wT)) / (T * factor)
                      : std::numeric_limits<double>::infinity();
  };
  constexpr int kSteps = 2000;
  constexpr double step = std::numbers::pi / kSteps;
  int lowest = 0;
  for (int i = 1; i <= kSteps; ++i)
    if (bound(i * step) < bound(lowest * step)) lowest = i;
  // The bound is smooth there: golden-section search within a step to either side.
  double low = std::max(0, lowest - 1) * step, high = std::min(kSteps, lowest + 1) * step;
  constexpr double golden = 1 / std::numbers::phi;
  for (int i = 0; i < 60; ++i) {
    const double a = high - golden * (high - low), c = low + golden * (high - low);
    (bound(a) < bound(c) ? high : low) = bound(a) < bound(c) ? c : a;
  }
  return std::max(0.0, std::min({bound(low), bound(high), bound(lowest * step)}));
}

double energy_per_cycle(double K, double amplitude, double w, double tick_s) {
  const double half = 0.5 * w * tick_s, s = math::sin(half);
  return std::numbers::pi * K * amplitude * amplitude * s * s / half;
}

DiolaitiPlace diolaiti_place(const WallLoop& loop, double K) {
  const double count = K * loop.axis.encoder_step;
  return {loop.axis.damping / (K * loop.tick_s),
          count > 0 ? loop.axis.friction / count : std::numeric_limits<double>::infinity()};
}

DiolaitiRegion diolaiti_region(const DiolaitiPlace& place) {
  if (place.beta > 0.5) return place.sigma > 0.5 ? DiolaitiRegion::settles : DiolaitiRegion::limit_cycle;
  return place.sigma > 0.5 ? DiolaitiRegion::settles_if_slow : DiolaitiRegion::grows;
}

}  // namespace fulcrum::analysis::stability
