// Each bound alone: a tone within all of them passes as it is; a push, a buzz and a source that feeds the
// hand are held.

#include "haptics/safety/transient_budget.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "haptics/safety/guard.h"

namespace fulcrum {
namespace {

constexpr double kTick = 1e-3;  // s
const double kPeak = TransientBudget::kPeak * DeviceDesc{}.max_force;

Vec3 tone(int i, double amplitude) {
  return {amplitude * std::sin(2 * std::numbers::pi * 200 * kTick * i), 0, 0};
}

TEST(TransientBudget, LetsAToneAtThePeakPassForEver) {
  TransientBudget budget(DeviceDesc{}, kTick);
  for (int i = 0; i < 5000; ++i) {
    const Vec3 allowed = budget.allow(tone(i, kPeak), Vec3::Zero());
    EXPECT_EQ(allowed, tone(i, kPeak)) << i;
    budget.commanded(allowed);
  }
}

TEST(TransientBudget, ShortensWhatIsAboveThePeak) {
  TransientBudget budget(DeviceDesc{}, kTick);
  const Vec3 allowed = budget.allow(Vec3(3, 4, 0), Vec3::Zero());
  EXPECT_NEAR((allowed - kPeak * Vec3(0.6, 0.8, 0)).norm(), 0, 1e-12);
}

// A push to one side ends after kPush of the peak, and none of it is left for the rest of the 100 ms.
TEST(TransientBudget, EndsAPush) {
  TransientBudget budget(DeviceDesc{}, kTick);
  std::vector<double> pushed;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 allowed = budget.allow(Vec3(0, kPeak / 2, 0), Vec3::Zero());
    budget.commanded(allowed);
    pushed.push_back(kTick * allowed.norm());
  }
  for (std::size_t i = 100; i < pushed.size(); ++i) {
    double sum = 0;
    for (std::size_t j = i - 99; j <= i; ++j) sum += pushed[j];
    ASSERT_LE(sum, TransientBudget::kPush * kPeak * (1 + 1e-9));
  }
}

TEST(TransientBudget, EndsABuzzThatIsAlwaysAtThePeak) {
  TransientBudget budget(DeviceDesc{}, kTick);
  double length = 0;
  for (int i = 0; i < 100; ++i) {
    const Vec3 allowed = budget.allow(Vec3(i % 2 == 0 ? kPeak : -kPeak, 0, 0), Vec3::Zero());
    budget.commanded(allowed);
    length += kTick * allowed.norm();
  }
  EXPECT_NEAR(length, TransientBudget::kLength * kPeak, kTick * kPeak);
}

// The handle goes along with the force: energy goes to the hand, is booked to the last bit and ends there.
TEST(TransientBudget, EndsASourceThatFeedsTheHand) {
  TransientBudget budget(DeviceDesc{}, kTick);
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
  EXPECT_LE(given, TransientBudget::kEnergy + kPeak * v * kTick);
}

// Beside a continuous force near the device's limit the sum stays within it, and the continuous part is
// whole.
TEST(Guard, TransientsGetWhatTheContinuousForceLeaves) {
  const DeviceDesc device;
  Guard guard(device, kTick, true);
  for (const double part : {0.0, 0.9, 0.99, 1.0}) {
    for (int i = 0; i < 600; ++i) {
      std::uint32_t faults = guard.watch({}, {});
      const Vec3 wanted(0, part * device.max_force, 0);
      const Wrench F = guard.limit({wanted, Vec3::Zero()}, faults);
      const Vec3 transient =
          guard.limit_transient(Vec3(0, tone(i, kPeak).x(), 0), F.force, Vec3::Zero(), faults);
      guard.commanded(F, transient);
      EXPECT_LE((F.force + transient).norm(), device.max_force * (1 + 1e-12));
    }
  }
}

// A stop takes the tone along: all of the force falls to nothing within 2 ms.
TEST(Guard, AStopEndsTransientsToo) {
  const DeviceDesc device;
  Guard guard(device, kTick, true);
  std::uint32_t faults = 0;
  Vec3 transient = Vec3::Zero();
  const auto tick = [&](std::span<const Command> commands) {
    faults = guard.watch({}, commands);
    const Wrench F = guard.limit({Vec3(0, 2, 0), Vec3::Zero()}, faults);
    transient = guard.limit_transient(Vec3(kPeak, 0, 0), F.force, Vec3::Zero(), faults);
    guard.commanded(F, Vec3::Zero());  // keeps the budget open: the stop alone is looked at
  };
  for (int i = 0; i < 600; ++i) tick({});
  EXPECT_EQ(transient, Vec3(kPeak, 0, 0));
  const Command stop{Command::Kind::stop};
  tick({&stop, 1});
  EXPECT_NEAR(transient.x(), kPeak / 2, 1e-12);
  tick({});
  EXPECT_EQ(transient, Vec3::Zero());
}

}  // namespace
}  // namespace fulcrum
