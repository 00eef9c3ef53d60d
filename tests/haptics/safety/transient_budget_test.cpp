// Each bound alone: a tone within all of them passes as it is; a push, a buzz and a source that feeds the
// hand are held.

#include "haptics/safety/transient_budget.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "haptics/safety/guard.h"
#include "tests/haptics/tick_length.h"

namespace fulcrum::test {
namespace {

constexpr TransientFigures kFigures = figures_of(TransientSource::torque_substitution);
constexpr TransientSource kSource[] = {TransientSource::torque_substitution};
const double kPeak = kFigures.peak * DeviceDesc{}.max_force;

Vec3 tone(int i, double amplitude) {
  return {amplitude * std::sin(2 * std::numbers::pi * 200 * kTick * i), 0, 0};
}

// Forces alone.
class ForceBudget {
public:
  Vec3 allow(const Vec3& wanted, const Vec3& moved) {
    Vec6 way = Vec6::Zero();
    way.head<3>() = moved;
    const Wrench allowed = budget_.allow({wanted, Vec3::Zero()}, way);
    EXPECT_EQ(allowed.torque, Vec3::Zero());
    return allowed.force;
  }
  void commanded(const Vec3& force) { budget_.commanded({force, Vec3::Zero()}); }
  double energy() const { return budget_.energy(); }

private:
  TransientBudget budget_{kFigures, DeviceDesc{}, kTick};
};

TEST(TransientBudget, LetsAToneAtThePeakPassForEver) {
  ForceBudget budget;
  for (int i = 0; i < 5000; ++i) {
    const Vec3 allowed = budget.allow(tone(i, kPeak), Vec3::Zero());
    EXPECT_EQ(allowed, tone(i, kPeak)) << i;
    budget.commanded(allowed);
  }
}

TEST(TransientBudget, ShortensWhatIsAboveThePeak) {
  ForceBudget budget;
  const Vec3 allowed = budget.allow(Vec3(3, 4, 0), Vec3::Zero());
  EXPECT_NEAR((allowed - kPeak * Vec3(0.6, 0.8, 0)).norm(), 0, 1e-12);
}

// A push to one side ends after kPush of the peak, and none of it is left for the rest of the 100 ms.
TEST(TransientBudget, EndsAPush) {
  ForceBudget budget;
  std::vector<double> pushed;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 allowed = budget.allow(Vec3(0, kPeak / 2, 0), Vec3::Zero());
    budget.commanded(allowed);
    pushed.push_back(kTick * allowed.norm());
  }
  for (std::size_t i = 100; i < pushed.size(); ++i) {
    double sum = 0;
    for (std::size_t j = i - 99; j <= i; ++j) sum += pushed[j];
    ASSERT_LE(sum, kFigures.push * kPeak * (1 + 1e-9));
  }
}

TEST(TransientBudget, EndsABuzzThatIsAlwaysAtThePeak) {
  ForceBudget budget;
  double length = 0;
  for (int i = 0; i < 100; ++i) {
    const Vec3 allowed = budget.allow(Vec3(i % 2 == 0 ? kPeak : -kPeak, 0, 0), Vec3::Zero());
    budget.commanded(allowed);
    length += kTick * allowed.norm();
  }
  EXPECT_NEAR(length, kFigures.length * kPeak, kTick * kPeak);
}

// The handle goes along with the force: energy goes to the hand, is booked to the last bit and ends there.
TEST(TransientBudget, EndsASourceThatFeedsTheHand) {
  ForceBudget budget;
  const double v = 1.0;  // m/s
  double given = 0;
  Vec3 last = Vec3::Zero();
  for (int i = 0; i < 100; ++i) {
    const Vec3 moved(i % 2 == 0 ? -v * kTick : v * kTick, 0, 0);
    given += last.dot(moved);
    last = budget.allow(Vec3(i % 2 == 0 ? kPeak : -kPeak, 0, 0), moved);
    budget.commanded(last);
  }
  EXPECT_NEAR(budget.energy(), given, 1e-15);
  EXPECT_LE(given, kFigures.energy + kPeak * v * kTick);
}

// What a force takes from the hand is no credit for a torque that feeds it.
TEST(TransientBudget, ForceAndTorqueAreBoundedEach) {
  DeviceDesc device;
  device.renders_torque = true;
  device.max_torque = 0.3;
  constexpr TransientFigures figures{
      .name = "energy alone", .peak = 1, .push = 1, .length = 1, .energy = 20e-3};
  TransientBudget budget(figures, device, kTick);
  const Wrench wanted{Vec3(0, 5, 0), Vec3(0, 0, 0.3)};
  Vec6 moved = Vec6::Zero();
  moved[1] = -2e-3;  // -10 mJ a tick
  moved[5] = 0.02;   // 6 mJ a tick
  int given = 0;
  for (int i = 0; i < 50; ++i) {
    const Wrench allowed = budget.allow(wanted, moved);
    budget.commanded(allowed);
    if (!allowed.is_zero()) ++given;
  }
  EXPECT_EQ(given, 4);  // the fourth takes it beyond 20 mJ
  EXPECT_NEAR(budget.torque_energy(), 4 * 6e-3, 1e-12);
  EXPECT_NEAR(budget.force_energy(), -4 * 10e-3, 1e-12);
}

// Beside a continuous force near the device's limit the sum stays within it, and the continuous part is
// whole.
TEST(Guard, TransientsGetWhatTheContinuousForceLeaves) {
  const DeviceDesc device;
  Guard guard(device, kTick, kSource);
  for (const double part : {0.0, 0.9, 0.99, 1.0}) {
    for (int i = 0; i < 600; ++i) {
      std::uint32_t faults = guard.watch({}, {});
      const Vec3 wanted(0, part * device.max_force, 0);
      const Wrench F = guard.limit({wanted, Vec3::Zero()}, faults);
      const Wrench transient = guard.limit_transient(
          kSource[0], {Vec3(0, tone(i, kPeak).x(), 0), Vec3::Zero()}, F, Vec6::Zero(), faults);
      guard.commanded(F);
      guard.commanded(kSource[0], transient);
      EXPECT_LE((F.force + transient.force).norm(), device.max_force * (1 + 1e-12));
    }
  }
}

// A stop takes the tone along: all of the force falls to nothing within 2 ms.
TEST(Guard, AStopEndsTransientsToo) {
  const DeviceDesc device;
  Guard guard(device, kTick, kSource);
  std::uint32_t faults = 0;
  Vec3 transient = Vec3::Zero();
  const auto tick = [&](std::span<const Command> commands) {
    faults = guard.watch({}, commands);
    const Wrench F = guard.limit({Vec3(0, 2, 0), Vec3::Zero()}, faults);
    // The budget is told of the last one alone, and stays open: the stop is what is looked at.
    transient =
        guard.limit_transient(kSource[0], {Vec3(kPeak, 0, 0), Vec3::Zero()}, F, Vec6::Zero(), faults).force;
    guard.commanded(F);
  };
  for (int i = 0; i < 600; ++i) tick({});
  EXPECT_EQ(transient, Vec3(kPeak, 0, 0));
  guard.commanded(kSource[0], {transient, Vec3::Zero()});
  const Command stop{Command::Kind::stop};
  tick({&stop, 1});
  EXPECT_NEAR(transient.x(), kPeak / 2, 1e-12);
  tick({});
  EXPECT_EQ(transient, Vec3::Zero());
}

// Torque is bounded as force is, each alone; what is beyond takes the whole wrench out.
TEST(TransientBudget, BoundsTorqueToo) {
  DeviceDesc device;
  device.renders_torque = true;
  device.max_torque = 0.3;
  const TransientFigures figures = figures_of(TransientSource::impact_vibration);
  const double peak = figures.peak * device.max_torque;
  TransientBudget budget(figures, device, kTick);
  EXPECT_EQ(budget.peak_torque(), peak);
  Wrench F = budget.allow({Vec3(0.01, 0, 0), Vec3(0, 0, 3)}, Vec6::Zero());
  EXPECT_NEAR(F.torque.z(), peak, 1e-15);
  EXPECT_EQ(F.force, Vec3(0.01, 0, 0));
  double pushed = 0, given = 0;
  Vec6 turned = Vec6::Zero();
  turned[5] = 1e-6;
  for (int i = 0; i < 100; ++i) {
    budget.commanded(F);
    pushed += kTick * F.torque.z();
    given += F.torque.z() * turned[5] + F.force.x() * turned[0];
    F = budget.allow({Vec3(0.01, 0, 0), Vec3(0, 0, peak)}, turned);
  }
  EXPECT_NEAR(pushed, figures.push * peak, kTick * peak);
  EXPECT_LE(pushed, figures.push * peak * (1 + 1e-12));
  EXPECT_TRUE(F.is_zero());
  EXPECT_NEAR(budget.energy(), given, 1e-15);
}

// The slowest tone that a material may have, at the peak, for ever: no bound but the energy's is in its way.
TEST(TransientBudget, LetsTwelveHertzAtThePeakPass) {
  TransientBudget budget(figures_of(TransientSource::impact_vibration), DeviceDesc{}, kTick);
  for (int i = 0; i < 5000; ++i) {
    const double level = std::sin(2 * std::numbers::pi * 12 * kTick * i);
    const Wrench wanted{Vec3(0, budget.peak() * level, 0), Vec3::Zero()};
    const Wrench allowed = budget.allow(wanted, Vec6::Zero());
    ASSERT_EQ(allowed.force, wanted.force) << i;
    budget.commanded(allowed);
  }
}

// What a device does not render has no budget.
TEST(TransientBudget, LetsNothingThroughThatTheDeviceHasNot) {
  DeviceDesc device;
  device.renders_force = false;
  device.renders_torque = true;
  device.max_torque = 0.1;
  TransientBudget budget(figures_of(TransientSource::impact_vibration), device, kTick);
  const Wrench F = budget.allow({Vec3::UnitX(), 1e-3 * Vec3::UnitX()}, Vec6::Zero());
  EXPECT_EQ(F.force, Vec3::Zero());
  EXPECT_EQ(F.torque, 1e-3 * Vec3::UnitX());
}

}  // namespace
}  // namespace fulcrum::test
