// The observer against the true work of a held force on a moving handle, and the control against a loop that
// makes energy.

#include "haptics/safety/energy_ledger.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "haptics/device/friction_axis.h"
#include "haptics/safety/passivity_control.h"

namespace fulcrum {
namespace {

constexpr double kTick = 1e-3;      // s
constexpr double kCount = 28e-6;    // m
constexpr double kStiffness = 800;  // N/m

Vec6 along_x(double d) {
  Vec6 v = Vec6::Zero();
  v[0] = d;
  return v;
}

EnergyLedger::Port pushing(double force, double springs = 0) {
  return {.F_H_W = {Vec3(force, 0, 0), Vec3::Zero()}, .springs = springs, .open = true};
}

double counted(double x, double count) {
  return count > 0 ? std::round(x / count) * count : x;
}

struct Books {
  double port = 0, truth = 0, worst = 0, largest_force = 0;
};

// A spring on the counted position, held from tick to tick, under a handle that goes where it is told.
Books follow(const std::function<double(double)>& path, double seconds, double count) {
  EnergyLedger ledger(1.0, true, true);
  CountedMotion motion(along_x(count));
  Books books;
  double x = path(0), q = counted(x, count), F = -kStiffness * q;
  ledger.book(Vec6::Zero(), Vec6::Zero(), pushing(F));
  for (int k = 1; k <= static_cast<int>(std::lround(seconds / kTick)); ++k) {
    const double x_next = path(k * kTick), d = counted(x_next, count) - q;
    books.truth -= F * (x_next - x);
    motion.update(along_x(d));
    x = x_next, q += d;
    F = -kStiffness * q;
    ledger.book(along_x(d), motion.within_tick(), pushing(F));
    books.largest_force = std::max(books.largest_force, std::abs(F));
    books.worst = std::max(books.worst, std::abs(ledger.port() - books.truth));
  }
  books.port = ledger.port();
  return books;
}

// There and back at speed v: the hold gives out k v T for every metre.
TEST(EnergyLedger, SeesWhatAHoldMakes) {
  const double v = 0.2, far = 0.02;
  const Books books = follow([&](double t) { return far - std::abs(far - v * t); }, 2 * far / v, 0);
  EXPECT_NEAR(books.port, -kStiffness * v * kTick * far, 1e-12);
  EXPECT_LT(books.worst, 1e-12);
}

// The handle is known to half a count on either side, so the work is known to that much of the force, however
// long it goes on; each reversal can hide what the hold makes within a count, and of what it makes along the
// way, k v T / 2 a metre, a tenth is missed where the speed changes between counts.
TEST(EnergyLedger, CountsOfAnEncoderMakeNoEnergy) {
  for (const double amplitude : {0.3, 0.55, 1.3, 4.0, 20.0, 300.0}) {
    for (const double frequency : {0.1, 1.0, 9.7, 60.0}) {
      const double A = amplitude * kCount, w = 2 * std::numbers::pi * frequency;
      const double speed = A * w, way = 4 * A * frequency * 10;
      if (speed > 1.0) continue;
      for (const double offset : {0.0, 0.5, 40.3}) {
        const Books books =
            follow([&](double t) { return offset * kCount + A * std::sin(w * t + 0.3); }, 10, kCount);
        const double known = books.largest_force * kCount;
        const double made = 0.5 * kStiffness * speed * kTick * way;
        const double reversals = 2 * frequency * 10 + 1;
        const double hidden = reversals * 0.5 * kStiffness * kCount * std::min(speed * kTick, kCount);
        EXPECT_LT(books.worst, known + hidden + 0.1 * made)
            << amplitude << " counts at " << frequency << " Hz from " << offset << ": " << books.port
            << " for " << books.truth;
      }
    }
  }
}

TEST(EnergyLedger, AHandThatTremblesAcrossOneCountGetsNothing) {
  const Books books =
      follow([](double t) { return (100 + 0.5 + 0.1 * std::sin(3141 * t)) * kCount; }, 60, kCount);
  EXPECT_GT(books.port, 0.1 * kPortBound);
}

// What the hand winds up on an axis that nobody pushes on comes in whole.
TEST(EnergyLedger, BooksUnrenderedAxesApart) {
  EnergyLedger ledger(0.5, true, false);
  EnergyLedger::Port port;
  port.open = true;
  ledger.book(Vec6::Zero(), Vec6::Zero(), port);
  Vec6 d = Vec6::Zero();
  d[4] = 0.1;
  port.F_H_W.torque = Vec3(0, -0.03, 0);
  ledger.book(d, d, port);
  EXPECT_NEAR(ledger.unrendered(), 0.5 * 0.5 * 0.03 * 0.1, 1e-15);
  EXPECT_NEAR(ledger.port(), ledger.unrendered(), 1e-15);
}

TEST(EnergyLedger, WeightIsAStoreAndSpringsAreAPurse) {
  EnergyLedger ledger(1.0, true, true);
  EnergyLedger::Port port;
  port.weight = 2.0;
  port.springs = 0.25;
  ledger.book(along_x(1), along_x(1), port);
  EXPECT_EQ(ledger.port(), 0);
  port.open = true;
  ledger.book(along_x(1), along_x(1), port);
  EXPECT_EQ(ledger.port(), 0.25);
  port.weight = 2.5;  // lifted by half a joule, by nobody's hand
  ledger.book(Vec6::Zero(), Vec6::Zero(), port);
  EXPECT_EQ(ledger.port(), -0.25);
}

// A handle on a spring, with nothing to damp it, two ticks of delay: unstable by theory at any stiffness.
// Returns the lowest state of the port and the last swing.
struct Loop {
  double lowest_port = 0, last_swing = 0;
};
Loop spring_loop(bool controlled, double stiffness, double count) {
  DeviceDesc device;
  PassivityControl control(device, kTick);
  EnergyLedger ledger(1.0, true, true);
  CountedMotion motion(along_x(count));
  FrictionAxis handle{.mass = device.handle_mass, .damping = 0, .friction = 0};
  handle.v = 0.05;
  std::array<double, 2> under_way{};
  double q = 0;
  Loop loop;
  ledger.book(Vec6::Zero(), Vec6::Zero(), pushing(0));
  for (int k = 0; k < 5000; ++k) {
    const double d = counted(handle.x, count) - q;
    q += d;
    motion.update(along_x(d));
    double F = -stiffness * q;
    if (controlled) F += control.resist(ledger.deficit(), motion.per_tick()).force.x();
    F = std::clamp(F, -device.max_force, device.max_force);
    ledger.book(along_x(d), motion.within_tick(), pushing(under_way[0], 0.5 * stiffness * q * q));
    FrictionAxis::Load load;
    load.force = under_way[0];
    handle.advance(load, kTick);
    under_way = {under_way[1], F};
    loop.lowest_port = std::min(loop.lowest_port, ledger.port());
    if (k > 4000) loop.last_swing = std::max(loop.last_swing, std::abs(handle.x));
  }
  return loop;
}

TEST(PassivityControl, HoldsALoopThatWouldMakeEnergy) {
  for (const double stiffness : {100.0, 400.0, 800.0}) {
    const double first_swing = 0.05 * std::sqrt(0.072 / stiffness);
    const Loop free = spring_loop(false, stiffness, kCount);
    EXPECT_GT(free.last_swing, 2 * first_swing) << "it was to grow";
    EXPECT_LT(free.lowest_port, 10 * kPortBound);
    const Loop held = spring_loop(true, stiffness, kCount);
    // What the port gave out, the handle has on top of what it came with.
    const double came_with = 0.5 * 0.072 * 0.05 * 0.05;
    EXPECT_LT(held.last_swing, first_swing * std::sqrt(1 - kPortBound / came_with)) << stiffness;
    EXPECT_GT(held.lowest_port, kPortBound) << stiffness;
  }
}

TEST(PassivityControl, PushesOnlyAgainstMotionAndOnlyWhereThereAreMotors) {
  DeviceDesc device;
  Vec6 per_tick;
  per_tick << 1e-5, -2e-5, 0, 1e-3, 0, 0;
  const Wrench F = PassivityControl(device, kTick).resist(5e-5, per_tick);
  EXPECT_LT(F.force.dot(per_tick.head<3>()), 0);
  EXPECT_NEAR(F.force.cross(Vec3(per_tick.head<3>())).norm(), 0, 1e-18);
  EXPECT_TRUE(F.torque.isZero(0));
  EXPECT_TRUE(PassivityControl(device, kTick).resist(1e-6, per_tick).is_zero());
  EXPECT_TRUE(PassivityControl(device, kTick).resist(1, Vec6::Zero()).is_zero());
  device.renders_force = false;
  EXPECT_TRUE(PassivityControl(device, kTick).resist(1, per_tick).is_zero());
}

}  // namespace
}  // namespace fulcrum
