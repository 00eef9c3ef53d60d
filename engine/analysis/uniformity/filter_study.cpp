#include "engine/analysis/uniformity/filter_study.h"

#include <cmath>
#include <complex>
#include <numbers>

#include "haptics/device/hand.h"
#include "haptics/loop/run_tick.h"
#include "haptics/math/functions.h"

namespace fulcrum::analysis::uniformity {
namespace {

constexpr double kJerks[] = {0.1, 0.3, 1, 3, 5, 10, 30, 100, 300, 1000};  // m/s^3 per root Hz
constexpr double kSettled = 1, kLength = 5;                               // s; whole periods of both motions
constexpr double kSlow = 2 * std::numbers::pi;                            // rad/s

double counted(double x, double step) {
  return std::round(x / step) * step;
}

// A hand that goes to and fro by 10 mm at 2 Hz, which is 1.6 m/s^2, and trembles. Its acceleration comes of
// differences over 0.1 ms: rounding leaves 1e-8 m/s^2 of error.
struct HandMotion {
  Tremor tremor{HandDesc{}};
  double x(double t) const { return 0.01 * math::sin(2 * kSlow * t) + tremor.at(t)[0]; }
  double a(double t) const {
    constexpr double d = 1e-4;
    return (x(t + d) - 2 * x(t) + x(t - d)) / (d * d);
  }
};

void measure(FilterRow& row, const AccelerationEstimatorDesc& desc, double encoder_step, double tick_s) {
  AccelerationEstimator exact(desc, tick_s), coarse(desc, tick_s), hand(desc, tick_s);
  row.lag = exact.lag();
  row.noise = exact.noise();
  const HandMotion motion;
  std::complex<double> swing;
  double noise = 0, error = 0;
  int measured = 0;
  const int ticks = static_cast<int>(std::lround(kLength / tick_s));
  for (int i = 0; i < ticks; ++i) {
    const double t = i * tick_s, x = 0.02 * math::sin(kSlow * t);
    const double a = exact.update(Vec3(x, 0, 0)).x();
    const double through = coarse.update(Vec3(counted(x, encoder_step), 0, 0)).x();
    const double felt = hand.update(Vec3(counted(motion.x(t), encoder_step), 0, 0)).x();
    if (t < kSettled) continue;
    ++measured;
    swing += a * std::complex(math::cos(kSlow * t), -math::sin(kSlow * t));
    noise += math::square(through - a);
    error += math::square(felt - motion.a(t));
  }
  row.measured_lag = math::atan2(swing.real(), swing.imag()) / kSlow;
  row.measured_noise = std::sqrt(noise / measured);
  row.error = std::sqrt(error / measured);

  constexpr int kTimed = 20'000;
  const std::int64_t before = thread_cpu_ns();
  for (int i = 0; i < kTimed; ++i) exact.update(Vec3(1e-6 * (i % 7), 0, 1e-6 * (i % 3)));
  row.cpu_ns = static_cast<double>(thread_cpu_ns() - before) / kTimed;
}

}  // namespace

std::vector<FilterRow> study_filters(double encoder_step, double tick_s) {
  std::vector<FilterRow> rows;
  for (const auto kind : {AccelerationEstimatorKind::kalman, AccelerationEstimatorKind::adaptive}) {
    for (const double jerk : kJerks) {
      FilterRow& row = rows.emplace_back();
      row.kind = kind;
      row.jerk = jerk;
      AccelerationEstimatorDesc desc;
      desc.kind = kind;
      desc.jerk = jerk;
      desc.noise = encoder_step / std::sqrt(12.0);
      measure(row, desc, encoder_step, tick_s);
    }
  }
  return rows;
}

}  // namespace fulcrum::analysis::uniformity
