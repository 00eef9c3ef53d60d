// The observer against the true work of a held force on a moving handle, and the control against a loop that
// makes energy.

#include "haptics/safety/passivity_observer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "haptics/device/friction_axis.h"
#include "haptics/estimate/encoder_motion.h"
#include "haptics/math/split_mix.h"
#include "haptics/safety/passivity_controller.h"
#include "tests/haptics/tick_length.h"

namespace fulcrum::test {
namespace {

constexpr double kCount = 28e-6;  // m
constexpr double kSpring = 800;   // N/m

Vec6 along_x(double d) {
  Vec6 v = Vec6::Zero();
  v[0] = d;
  return v;
}

PassivityObserver::Port pushing(double force, double springs = 0) {
  PassivityObserver::Port port;
  port.F_H_D.force.x() = force;
  port.springs = springs;
  port.open = true;
  return port;
}

double counted(double x, double count) {
  return count > 0 ? std::round(x / count) * count : x;
}

struct Books {
  double port = 0, truth = 0;
  double above = 0, below = 0;  // J, the most that the port read above the truth, and below
  double changes = 0;           // N, of force, all together
  double way = 0;               // m
};

using Path = std::function<double(double time)>;

struct Loop {
  double count = kCount, stiffness = kSpring,
         damping = 0;  // m, N/m, N s/m; of the velocity in a low-pass of 60 Hz
};

// A spring and a damper on the counted position, held from tick to tick, under a handle that goes where it is
// told.
Books follow(const Path& path, double seconds, const Loop& loop) {
  PassivityObserver observer(along_x(loop.count), true, true);
  const double keep = std::exp(-2 * std::numbers::pi * 60 * kTick);
  Books books;
  double x = path(0), q = counted(x, loop.count), F = -loop.stiffness * q, v = 0;
  observer.update(Vec6::Zero(), pushing(F));
  for (int k = 1; k <= static_cast<int>(std::lround(seconds / kTick)); ++k) {
    const double x_next = path(k * kTick), q_next = counted(x_next, loop.count), d = q_next - q;
    books.truth -= F * (x_next - x);
    books.way += std::abs(x_next - x);
    x = x_next, q = q_next;
    v = keep * v + (1 - keep) * d / kTick;
    const double F_next = -loop.stiffness * q - loop.damping * v;
    books.changes += std::abs(F_next - F);
    F = F_next;
    observer.update(along_x(d), pushing(F));
    books.above = std::max(books.above, observer.port() - books.truth);
    books.below = std::max(books.below, books.truth - observer.port());
  }
  books.port = observer.port();
  return books;
}

constexpr double kBits = 1e-11;  // J, of rounding

// There and back at speed v: the hold gives out k v T for every metre.
TEST(PassivityObserver, SeesWhatAHoldMakes) {
  const double v = 0.2, far = 0.02;
  const Books books =
      follow([&](double t) { return far - std::abs(far - v * t); }, 2 * far / v, {.count = 0});
  EXPECT_NEAR(books.port, -kSpring * v * kTick * far, 1e-12);
  EXPECT_LT(std::max(books.above, books.below), 1e-12);
}

// The tremor of a hand.
Path trembling(double rms, std::uint64_t seed) {
  struct Tone {
    double w, phase;
  };
  SplitMix random(seed);
  std::vector<Tone> tones;
  for (int i = 0; i < 6; ++i)
    tones.push_back(
        {2 * std::numbers::pi * (8 + 4 * random.uniform()), 2 * std::numbers::pi * random.uniform()});
  return [=](double t) {
    double x = 2e-3;
    for (const Tone& tone : tones) x += rms / std::sqrt(3.0) * std::sin(tone.w * t + tone.phase);
    return x;
  };
}

TEST(PassivityObserver, ReadsNoBetterThanTheTruthUnderTremor) {
  for (const double count : {2e-6, 10e-6, 28e-6, 100e-6, 300e-6}) {
    for (const double rms : {5e-6, 20e-6, 50e-6, 150e-6, 500e-6}) {
      for (const double damping : {0.0, 4.0, 25.0}) {
        const Books books = follow(trembling(rms, 7), 24, {count, 2000, damping});
        EXPECT_LT(books.above, kBits) << count << " m counts, tremor " << rms << " m, damping " << damping;
        EXPECT_LT(books.below, count * (books.changes + 20));
      }
    }
  }
}

TEST(PassivityObserver, ReadsNoBetterThanTheTruthUnderATone) {
  for (const double count : {2e-6, 28e-6, 100e-6, 1e-3}) {
    for (const double amplitude : {0.3, 0.55, 1.3, 4.0, 20.0, 300.0}) {
      for (const double frequency : {0.1, 1.0, 9.7, 60.0, 233.3}) {
        const double A = amplitude * count, w = 2 * std::numbers::pi * frequency;
        if (A * w > 10.0) continue;
        for (const double offset : {0.0, 0.5, 40.3}) {
          const Books books = follow([&](double t) { return offset * count + A * std::sin(w * t + 0.3); }, 4,
                                     {.count = count});
          EXPECT_LT(books.above, kBits)
              << amplitude << " counts of " << count << " m at " << frequency << " Hz";
          EXPECT_LE(books.below, count * (books.changes + 3 * kSpring * (A + 41 * count)));
        }
      }
    }
  }
}

// Presses with tremor on them, and a hand that wanders.
TEST(PassivityObserver, ReadsNoBetterThanTheTruthOfAHandAtWork) {
  for (const double count : {10e-6, 28e-6, 100e-6}) {
    for (const double damping : {0.0, 25.0}) {
      const Path tremor = trembling(50e-6, 3);
      const Books pressed =
          follow([&](double t) { return 1e-3 * (1 - std::cos(2 * std::numbers::pi * 0.7 * t)) + tremor(t); },
                 24, {count, 2000, damping});
      EXPECT_LT(pressed.above, kBits) << count;
      SplitMix random(11);
      double x = 0, v = 0;
      const Books wandered = follow(
          [&](double) {
            v = 0.99 * v + 1e-3 * random.normal();
            x = 0.999 * x + v * kTick;
            return x;
          },
          24, {count, 2000, damping});
      EXPECT_LT(wandered.above, kBits) << count;
    }
  }
}

// By how much less it reads: with the way and with the hold, and for slow hands not with the count. Half of
// the way of a tick is what the hold really makes; four times that is what it may have made.
TEST(PassivityObserver, ReadsLittleLessThanTheTruth) {
  for (const double count : {2e-6, 10e-6, 28e-6, 100e-6}) {
    const Books books = follow(trembling(150e-6, 7), 24, {count, 2000, 0});
    const double made = -books.truth;  // by the hold
    EXPECT_GT(made, 1e-3);
    EXPECT_LT(books.below, 6 * made) << count;
  }
}

// A handle that stands still and jumps hides at most a count for each change of force.
TEST(PassivityObserver, AJumpHidesNoMoreThanACountOfTheChangeOfForce) {
  SplitMix random(5);
  for (int i = 0; i < 100; ++i) {
    const double count = std::exp(-12 + 4 * random.uniform()), reach = count * std::exp(6 * random.uniform());
    double x = 0, wait = 0;
    const Books books = follow(
        [&](double) {
          if ((wait -= 1) < 0) {
            wait = 30 * random.uniform();
            x = reach * (2 * random.uniform() - 1);
          }
          return x;
        },
        1, {count, 2000, 0});
    EXPECT_LT(books.above, count * books.changes + kBits) << count;
  }
}

// What the hand winds up on an axis that nobody pushes on comes in whole.
TEST(PassivityObserver, BooksUnrenderedAxesApart) {
  const Vec6 counts = Vec6::Constant(1e-3);
  PassivityObserver observer(counts, true, false);
  PassivityObserver::Port port;
  port.open = true;
  observer.update(Vec6::Zero(), port);
  Vec6 d = Vec6::Zero();
  d[4] = 0.1;
  port.F_H_D.torque = Vec3(0, -0.03, 0);
  observer.update(d, port);
  EXPECT_NEAR(observer.unrendered(), 0.5 * 0.03 * 0.1, 1e-15);
  EXPECT_NEAR(observer.port(), observer.unrendered(), 1e-15);
}

TEST(PassivityObserver, WeightIsAStoreAndSpringsAreAPurse) {
  PassivityObserver observer(Vec6::Zero(), true, true);
  PassivityObserver::Port port;
  port.weight = 2.0;
  port.springs = 0.25;
  observer.update(along_x(1), port);
  EXPECT_EQ(observer.port(), 0);
  port.open = true;
  observer.update(along_x(1), port);
  EXPECT_EQ(observer.port(), 0.25);
  port.weight = 2.5;  // lifted by half a joule, by nobody's hand
  observer.update(Vec6::Zero(), port);
  EXPECT_EQ(observer.port(), -0.25);
}

// A handle on a spring, with nothing to damp it, two ticks of delay: unstable by theory at any stiffness.
struct Swinging {
  double lowest_port = 0,
         lowest_truth = 0;  // J, what the handle was given at the most, with the sign of the port
  double port_above = 0;    // J, the most that the port read above the truth
  double last_swing = 0;    // m
};
Swinging spring_loop(bool controlled, double stiffness, double count) {
  DeviceDesc device;
  PassivityController control(device, kTick);
  PassivityObserver observer(along_x(count), true, true);
  EncoderMotion motion(along_x(count));
  FrictionAxis handle{.mass = device.handle_mass, .damping = 0, .friction = 0};
  handle.v = 0.05;
  std::array<double, 2> under_way{};
  double q = 0, truth = 0;
  Swinging loop;
  observer.update(Vec6::Zero(), pushing(0));
  for (int k = 0; k < 5000; ++k) {
    const double d = counted(handle.x, count) - q;
    q += d;
    motion.update(along_x(d));
    double F = -stiffness * q;
    if (controlled) F += control.resist(observer.deficit(), motion.per_tick()).force.x();
    F = std::clamp(F, -device.max_force, device.max_force);
    observer.update(along_x(d), pushing(under_way[0], 0.5 * stiffness * q * q));
    FrictionAxis::Load load;
    load.force = under_way[0];
    loop.lowest_port = std::min(loop.lowest_port, observer.port());
    loop.lowest_truth = std::min(loop.lowest_truth, truth);
    loop.port_above = std::max(loop.port_above, observer.port() - truth);
    const double x = handle.x;
    handle.advance(load, kTick);
    truth -= under_way[0] * (handle.x - x);
    under_way = {under_way[1], F};
    if (k > 4000) loop.last_swing = std::max(loop.last_swing, std::abs(handle.x));
  }
  return loop;
}

TEST(PassivityController, HoldsALoopThatWouldMakeEnergy) {
  for (const double stiffness : {100.0, 400.0, 800.0}) {
    const double first_swing = 0.05 * std::sqrt(0.072 / stiffness);
    const Swinging free = spring_loop(false, stiffness, kCount);
    EXPECT_GT(free.last_swing, 2 * first_swing) << "it was to grow";
    EXPECT_LT(free.lowest_port, 10 * kPortBound);
    const Swinging held = spring_loop(true, stiffness, kCount);
    // What the port gave out, the handle has on top of what it came with.
    const double came_with = 0.5 * 0.072 * 0.05 * 0.05;
    EXPECT_LT(held.last_swing, first_swing * std::sqrt(1 - kPortBound / came_with)) << stiffness;
    EXPECT_GT(held.lowest_truth, kPortBound) << stiffness;
    EXPECT_LT(held.port_above, kBits) << stiffness;
  }
}

TEST(PassivityController, PushesOnlyAgainstMotionAndOnlyWhereThereAreMotors) {
  DeviceDesc device;
  Vec6 per_tick;
  per_tick << 1e-5, -2e-5, 0, 1e-3, 0, 0;
  const Wrench F = PassivityController(device, kTick).resist({.made = 5e-5}, per_tick);
  EXPECT_LT(F.force.dot(per_tick.head<3>()), 0);
  EXPECT_NEAR(F.force.cross(Vec3(per_tick.head<3>())).norm(), 0, 1e-18);
  EXPECT_TRUE(F.torque.isZero(0));
  EXPECT_TRUE(PassivityController(device, kTick).resist({.made = 1e-6}, per_tick).is_zero());
  EXPECT_TRUE(PassivityController(device, kTick).resist({.made = 1}, Vec6::Zero()).is_zero());
  device.renders_force = false;
  EXPECT_TRUE(PassivityController(device, kTick).resist({.made = 1}, per_tick).is_zero());
}

}  // namespace
}  // namespace fulcrum::test
