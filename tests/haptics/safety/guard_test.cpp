// The figures of the contract: within 2 ms to nothing, in half a second to the whole, from nothing to the
// limit in no less than 5 ms; what raises each fault; and what acknowledges a stop.

#include "haptics/safety/guard.h"
#include "tests/haptics/tick_length.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace fulcrum::test {
namespace {

const Command kAcknowledge{Command::Kind::acknowledge};

class Held {
public:
  // later: faults that are found after the commands have been read.
  double tick(std::span<const Command> commands, std::uint32_t later = 0) {
    std::uint32_t faults = guard_.watch({}, commands);
    if (later != 0) guard_.stop(later);
    const Wrench F = guard_.limit({Vec3(0, 2, 0), Vec3::Zero()}, faults);
    guard_.commanded(F);
    return F.force.norm();
  }
  bool stopped() const { return guard_.stopped(); }

private:
  Guard guard_{DeviceDesc{}, kTick, {}};
};

// Somebody leans on the key while the cause is still there: the force is gone after 2 ms, and stays away.
TEST(Guard, AcknowledgementsDoNotKeepAForceThatFalls) {
  Held held;
  for (int i = 0; i < 600; ++i) held.tick({});
  EXPECT_EQ(held.tick({&kAcknowledge, 1}, kNotFinite), 1.0);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(held.tick({&kAcknowledge, 1}, kNotFinite), 0.0) << i;
}

// One that comes while the force falls is not lost.
TEST(Guard, AnAcknowledgementWaitsForTheFall) {
  Held held;
  for (int i = 0; i < 600; ++i) held.tick({});
  held.tick({}, kNotFinite);
  EXPECT_EQ(held.tick({&kAcknowledge, 1}), 0.0);
  EXPECT_TRUE(held.stopped());
  const double first = held.tick({});
  EXPECT_FALSE(held.stopped());
  EXPECT_GT(first, 0);
  EXPECT_LE(first, 2 * kTick / kRampIn * (1 + 1e-12));
}

// What is released goes as it came, half a second long, and is stopped then; an acknowledgement brings it
// back.
TEST(Guard, AReleaseRampsOutToAStop) {
  Held held;
  for (int i = 0; i < 600; ++i) held.tick({});
  const Command release{Command::Kind::release};
  double before = held.tick({&release, 1});
  int ticks = 1;
  while (!held.stopped() && ticks < 1000) {
    const double now = held.tick({});
    EXPECT_LE(now, before);
    EXPECT_LE(before - now, 2 * kTick / kRampIn * (1 + 1e-9)) << ticks;
    before = now;
    ++ticks;
  }
  EXPECT_NEAR(ticks * kTick, kRampIn, 3 * kTick);
  EXPECT_EQ(before, 0);
  held.tick({&kAcknowledge, 1});
  for (int i = 0; i < 600; ++i) held.tick({});
  EXPECT_FALSE(held.stopped());
  EXPECT_NEAR(held.tick({}), 2, 1e-12);
}

// A stop in between is a stop, and nothing of the release is left after it.
TEST(Guard, AStopDuringAReleaseEndsIt) {
  Held held;
  for (int i = 0; i < 600; ++i) held.tick({});
  const Command release{Command::Kind::release}, stop{Command::Kind::stop};
  for (int i = 0; i < 100; ++i) held.tick({&release, 1});
  held.tick({&stop, 1});
  held.tick({});
  EXPECT_EQ(held.tick({&release, 1}), 0);
  held.tick({&kAcknowledge, 1});
  for (int i = 0; i < 600; ++i) held.tick({});
  EXPECT_NEAR(held.tick({}), 2, 1e-12);
}

// A fault that comes in between takes it back.
TEST(Guard, AFaultDuringTheFallTakesTheAcknowledgementBack) {
  Held held;
  for (int i = 0; i < 600; ++i) held.tick({});
  held.tick({}, kNotFinite);
  held.tick({&kAcknowledge, 1});
  const Command stop{Command::Kind::stop};
  held.tick({&stop, 1});
  for (int i = 0; i < 10; ++i) EXPECT_EQ(held.tick({}), 0.0);
  EXPECT_TRUE(held.stopped());
}

// What a sample or a command says is wrong stops the force, and is named; what is right does neither.
TEST(Guard, EachFaultOfASampleOrACommandStops) {
  struct Case {
    std::uint32_t bit;
    DeviceSample sample;
    std::vector<Command> commands;
  };
  const auto changed = [](auto&& change) {
    DeviceSample sample;
    change(sample);
    return sample;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const std::vector<Case> cases = {
      {0, {}, {}},
      {0, changed([](DeviceSample& s) { s.age = 20e-3; }), {}},
      {0, changed([](DeviceSample& s) { s.X_DH.p.x() = 999; }), {}},
      {kStopRequested, {}, {{Command::Kind::stop}}},
      {kWatchdog, {}, {{Command::Kind::watchdog}}},
      {kUnanswered, {}, {{Command::Kind::unanswered}}},
      {kUnanswered, {}, {{Command::Kind::acknowledge}, {Command::Kind::unanswered}}},
      {kSampleStale, changed([](DeviceSample& s) { s.age = 20.1e-3; }), {}},
      {kSampleStale, changed([&](DeviceSample& s) { s.age = inf; }), {}},
      {kDeviceLost, changed([](DeviceSample& s) { s.connected = false; }), {}},
      {kNotFinite, changed([&](DeviceSample& s) { s.X_DH.p.y() = nan; }), {}},
      {kNotFinite, changed([&](DeviceSample& s) { s.X_DH.q.w() = inf; }), {}},
      {kNotFinite, changed([](DeviceSample& s) { s.X_DH.q = Quat(0, 0, 0, 0); }), {}},
      {kNotFinite, changed([](DeviceSample& s) { s.X_DH.p.z() = -1001; }), {}},
      {kNotFinite, changed([&](DeviceSample& s) { s.age = nan; }), {}},
      {kNotFinite, changed([](DeviceSample& s) { s.age = -1e-6; }), {}},
  };
  for (std::size_t i = 0; i < cases.size(); ++i) {
    Guard guard(DeviceDesc{}, kTick, {});
    EXPECT_EQ(guard.watch(cases[i].sample, cases[i].commands), cases[i].bit) << i;
    EXPECT_EQ(guard.stopped(), cases[i].bit != 0) << i;
    EXPECT_EQ(guard.reason(), cases[i].bit) << i;
  }
}

// Without motors no force answers an old sample: the tool only goes on as it was told, for a tenth of a
// second.
TEST(Guard, ASampleOfADeviceWithoutMotorsMayBeOlder) {
  const auto faults_at = [](bool force, bool torque, double age) {
    DeviceDesc device;
    device.renders_force = force;
    device.renders_torque = torque;
    DeviceSample sample;
    sample.age = age;
    return Guard(device, kTick, {}).watch(sample, {});
  };
  EXPECT_EQ(faults_at(false, false, 0.0999), 0u);
  EXPECT_EQ(faults_at(false, false, 0.1001), static_cast<std::uint32_t>(kSampleStale));
  for (const auto& [force, torque] : {std::pair(true, false), std::pair(false, true), std::pair(true, true)})
    EXPECT_EQ(faults_at(force, torque, 0.0201), static_cast<std::uint32_t>(kSampleStale)) << force << torque;
}

// Pushes until nothing changes any more; the faults are those of all ticks after the ramp.
struct Rested {
  Wrench F;
  std::uint32_t faults = 0;
};
Rested pushed(const DeviceDesc& device, const Wrench& wanted) {
  Guard guard(device, kTick, {});
  Rested rested;
  for (int i = 0; i < 1000; ++i) {
    std::uint32_t faults = guard.watch({}, {});
    rested.F = guard.limit(wanted, faults);
    guard.commanded(rested.F);
    if (i >= 600) rested.faults |= faults;
  }
  return rested;
}

TEST(Guard, ForceAndTorqueAreClampedEachAndTheirDirectionIsKept) {
  DeviceDesc device;
  device.renders_torque = true;
  device.max_force = 3;
  device.max_torque = 0.2;
  const Wrench small{Vec3(1, -2, 2), Vec3(0.1, 0, -0.1)};
  EXPECT_EQ(pushed(device, small).F.force, small.force);
  EXPECT_EQ(pushed(device, small).F.torque, small.torque);
  EXPECT_EQ(pushed(device, small).faults, 0u);

  const Rested force = pushed(device, {10 * small.force, small.torque});
  EXPECT_EQ(force.faults, static_cast<std::uint32_t>(kForceClamped));
  EXPECT_NEAR((force.F.force - small.force).norm(), 0, 1e-12);  // small.force is 3 N
  EXPECT_EQ(force.F.torque, small.torque);

  const Rested torque = pushed(device, {small.force, 10 * small.torque});
  EXPECT_EQ(torque.faults, static_cast<std::uint32_t>(kTorqueClamped));
  EXPECT_NEAR((torque.F.torque - 0.2 * small.torque.normalized()).norm(), 0, 1e-12);
  EXPECT_EQ(torque.F.force, small.force);

  device.renders_torque = false;  // it lacks the axis: nothing is commanded there, and that is no event
  EXPECT_EQ(pushed(device, {small.force, 10 * small.torque}).F.torque, Vec3(0, 0, 0));
  EXPECT_EQ(pushed(device, {small.force, 10 * small.torque}).faults, 0u);
}

TEST(Guard, AStepTakesFiveMillisecondsAndSaysSo) {
  DeviceDesc device;
  device.max_force = 4;
  Guard guard(device, kTick, {});
  const auto tick = [&](double force, std::uint32_t& faults) {
    faults = guard.watch({}, {});
    const Wrench F = guard.limit({Vec3(force, 0, 0), Vec3::Zero()}, faults);
    guard.commanded(F);
    return F.force.x();
  };
  std::uint32_t faults = 0;
  for (int i = 0; i < 600; ++i) tick(0, faults);
  double last = 0;
  for (int i = 1; i <= 5; ++i) {
    const double force = tick(4, faults);
    EXPECT_NEAR(force - last, 0.8, 1e-12) << i;
    EXPECT_EQ((faults & kSlewLimited) != 0, i < 5) << i;
    last = force;
  }
  EXPECT_NEAR(tick(-4, faults), 3.2, 1e-12);
}

TEST(Guard, TheForceReturnsOverHalfASecondInAStraightLine) {
  DeviceDesc device;
  device.max_force = 4;
  Guard guard(device, kTick, {});
  for (int i = 1; i <= 700; ++i) {
    std::uint32_t faults = guard.watch({}, {});
    const Wrench F = guard.limit({Vec3(2, 0, 0), Vec3::Zero()}, faults);
    guard.commanded(F);
    EXPECT_NEAR(F.force.x(), 2 * std::min(1.0, i * kTick / 0.5), 1e-12) << i;
  }
}

TEST(Guard, AStopTakesTwoMillisecondsWhateverIsWanted) {
  Held held;
  for (int i = 0; i < 600; ++i) held.tick({});
  const Command stop{Command::Kind::stop};
  EXPECT_NEAR(held.tick({&stop, 1}), 1.0, 1e-12);  // of 2 N
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(held.tick({}), 0.0) << i;
}

// Each bit has a name of its own and a sentence, and each that stops is below the sixteenth.
TEST(Faults, EachBitHasANameAndASentence) {
  std::uint32_t seen = 0;
  for (const FaultName& fault : fault_names()) {
    EXPECT_EQ(seen & fault.bit, 0u) << fault.name;
    seen |= fault.bit;
    EXPECT_TRUE(std::string(fault.sentence).ends_with('.')) << fault.name;
  }
  for (const std::uint32_t bit :
       {kStopRequested, kNotFinite, kSampleStale, kDeviceLost, kWatchdog, kToolInside, kUnanswered})
    EXPECT_TRUE(seen & kStoppingFaults & bit) << bit;
  for (const std::uint32_t bit : {kForceClamped, kTorqueClamped, kSlewLimited, kMotorClamped, kMotionLimited,
                                  kStiffnessCapped, kContactsReduced, kEnergyBound, kPassivityControl,
                                  kTransientLimited, kHoldingPointLost, kCompensationFaded, kOutputLimited})
    EXPECT_TRUE(seen & ~kStoppingFaults & bit) << bit;
}

TEST(Faults, APauseIsAStopInWhichNothingIsWrong) {
  for (const std::uint32_t faults : {std::uint32_t{kStopRequested}, std::uint32_t{kUnanswered},
                                     kStopRequested | kUnanswered, kUnanswered | kSlewLimited})
    EXPECT_TRUE(is_pause(faults)) << faults;
  for (const std::uint32_t faults :
       {std::uint32_t{0}, std::uint32_t{kSlewLimited}, std::uint32_t{kSampleStale},
        kStopRequested | kDeviceLost, kUnanswered | kNotFinite})
    EXPECT_FALSE(is_pause(faults)) << faults;
}

}  // namespace
}  // namespace fulcrum::test
