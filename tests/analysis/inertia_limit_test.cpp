// References: the loop run tick by tick with its own filter or its own delay, integrated in steps of a
// thousandth of a tick; the poles of a mass on a spring; the first-order formula where the lag is short
// beside the swing.

#include "engine/analysis/uniformity/inertia_limit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <deque>

namespace fulcrum::analysis::uniformity {
namespace {

// 1/s, from the swing's turning points after the first third of a run.
template <class Estimate>
double simulated_growth(const InertiaLoop& loop, double seconds, Estimate&& estimate) {
  const double mass = loop.device_mass + loop.hand_mass;
  double x = 1e-3, v = 0, held = 0;
  double first = 0, last = 0, first_time = 0, last_time = 0;  // m, s
  const int ticks = static_cast<int>(seconds / loop.tick_s);
  for (int i = 0; i < ticks; ++i) {
    const double a = (held - loop.damping * v - loop.hand_stiffness * x) / mass;
    const double v_before = v;
    held = -loop.wall_stiffness * x + loop.gain * loop.device_mass * estimate(x, a);
    constexpr int kSteps = 200;
    const double h = loop.tick_s / kSteps;
    for (int k = 0; k < kSteps; ++k) {  // the midpoint rule
      const auto accelerate = [&](double p, double u) {
        return (held - loop.damping * u - loop.hand_stiffness * p) / mass;
      };
      const double v_half = v + 0.5 * h * accelerate(x, v), x_half = x + 0.5 * h * v;
      x += h * v_half;
      v += h * accelerate(x_half, v_half);
    }
    if (v * v_before < 0 && 3 * i > ticks) {
      last = std::abs(x);
      last_time = i * loop.tick_s;
      if (first == 0) {
        first = last;
        first_time = last_time;
      }
    }
  }
  return std::log(last / first) / (last_time - first_time);
}

TEST(InertiaLimit, WithoutCompensationItIsAMassOnASpring) {
  InertiaLoop loop;
  loop.gain = 0;
  // Underdamped: it decays with b / 2 m, whatever the tick.
  const double decay = loop.damping / (2 * (loop.device_mass + loop.hand_mass));
  EXPECT_NEAR(growth(loop, 1), -decay, 1e-9);
  loop.tick_s = 1e-4;
  EXPECT_NEAR(growth(loop, 3), -decay, 1e-8);
}

TEST(InertiaLimit, GrowsAsTheLoopDoesTickByTick) {
  for (const double wall : {0.0, 300.0}) {
    for (const double jerk : {1.0, 5.0, 100.0}) {
      InertiaLoop loop;
      loop.wall_stiffness = wall;
      AccelerationEstimatorDesc desc;
      desc.jerk = jerk;
      AccelerationEstimator filter(desc, loop.tick_s);
      filter.update(Vec3::Zero());
      const double seen =
          simulated_growth(loop, 2, [&](double x, double) { return filter.update(Vec3(x, 0, 0)).x(); });
      EXPECT_NEAR(seen, growth(loop, filter.steady()), 0.3) << wall << ' ' << jerk;
    }
    for (const int ticks : {1, 8}) {
      InertiaLoop loop;
      loop.wall_stiffness = wall;
      std::deque<double> past(static_cast<std::size_t>(ticks), 0.0);
      const double seen = simulated_growth(loop, 2, [&](double, double a) {
        past.push_front(a);
        const double late = past.back();
        past.pop_back();
        return late;
      });
      EXPECT_NEAR(seen, growth(loop, ticks), 0.3) << wall << ' ' << ticks;
    }
  }
}

TEST(InertiaLimit, IsTheFormulaWhereTheLagIsShort) {
  for (const double gain : {0.8, 1.0}) {
    InertiaLoop loop;  // a slow swing: 2 Hz, of which 10 ms are a small part
    loop.gain = gain;
    loop.hand_mass = 0.5;
    loop.damping = 0.5;
    loop.hand_stiffness = 100;
    EXPECT_NEAR(largest_filter_lag(loop), first_order_lag(loop), 0.1 * first_order_lag(loop)) << gain;
    EXPECT_NEAR(largest_delay(loop), first_order_lag(loop), 0.1 * first_order_lag(loop) + loop.tick_s)
        << gain;
  }
}

TEST(InertiaLimit, LessLagIsBorneByALighterHandAndAStifferBall) {
  InertiaLoop loop;
  const double as_is = largest_filter_lag(loop);
  loop.hand_mass /= 2;
  EXPECT_LT(largest_filter_lag(loop), as_is);
  loop.hand_mass *= 2;
  loop.wall_stiffness = 600;
  EXPECT_LT(largest_filter_lag(loop), as_is);
  loop.gain = 0.1;
  EXPECT_TRUE(std::isinf(largest_filter_lag(loop)));
}

}  // namespace
}  // namespace fulcrum::analysis::uniformity
