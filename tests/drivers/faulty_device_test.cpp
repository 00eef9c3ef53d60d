#include "drivers/fault/faulty_device.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace fulcrum {
namespace {

constexpr double kTick = 1e-3;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// Moves 1 mm and turns a little with every sample, and remembers what it was told.
class Moving final : public Device {
public:
  Moving(double strip_ohm, std::vector<DeviceCommand>& told) : strip_ohm_(strip_ohm), told_(told) {}
  const DeviceDesc& desc() const override { return desc_; }
  DeviceSample read() noexcept override {
    ++n_;
    DeviceSample sample;
    sample.X_DH = pose(n_);
    sample.age = 1e-4;
    sample.strip_ohm = strip_ohm_;
    return sample;
  }
  void write(const DeviceCommand& command) noexcept override { told_.push_back(command); }
  void miss(int ticks) noexcept override { missed += ticks; }
  static Pose pose(int n) {
    const double half = 5e-4 * n;
    return {Quat(std::cos(half), 0, std::sin(half), 0), Vec3(1e-3 * n, 0, 0)};
  }
  int missed = 0;

private:
  DeviceDesc desc_;
  double strip_ohm_;
  std::vector<DeviceCommand>& told_;
  int n_ = 0;
};

struct Trial {
  std::vector<DeviceSample> samples;  // the first is of tick 0
  std::vector<DeviceCommand> told;    // 1 N up in every tick
};
Trial tried(Injection kind, double at, int ticks, double strip_ohm = kNan) {
  Trial trial;
  FaultyDevice device(std::make_unique<Moving>(strip_ohm, trial.told), {kind, at}, kTick);
  for (int n = 0; n < ticks; ++n) {
    trial.samples.push_back(device.read());
    DeviceCommand up;
    up.F_H_D.force = Vec3(0, 1, 0);
    up.effort[0] = 1;
    device.write(up);
  }
  return trial;
}

bool is_true(const DeviceSample& sample, int tick) {
  const Pose pose = Moving::pose(tick + 1);
  return sample.connected && sample.age == 1e-4 && sample.X_DH.p == pose.p &&
         sample.X_DH.q.coeffs() == pose.q.coeffs();
}

// Before it begins, and after its end, a fault changes nothing. first, end: ticks.
void expect_only(Injection kind, int first, int end, double strip_ohm = kNan) {
  const Trial trial = tried(kind, first * kTick, end + 100, strip_ohm);
  for (int n = 0; n < end + 100; ++n) {
    const auto i = static_cast<std::size_t>(n);
    const bool spoilt = n >= first && n < end;
    const bool as_it_is =
        is_true(trial.samples[i], n) && (std::isnan(strip_ohm) || trial.samples[i].strip_ohm == strip_ohm);
    EXPECT_EQ(as_it_is, !spoilt) << name_of(kind) << " at tick " << n;
  }
}

TEST(FaultyDevice, AFaultBeginsWhenItIsDueAndEnds) {
  expect_only(Injection::replug, 100, 600);
  expect_only(Injection::stall, 100, 600);
  expect_only(Injection::short_read, 100, 110);
  expect_only(Injection::garbage, 100, 105);
  expect_only(Injection::nan, 100, 101);
  expect_only(Injection::frozen, 100, 4100);
  expect_only(Injection::late_reply, 100, 600);
  expect_only(Injection::write_fail, 100, 600);
  expect_only(Injection::sensor_drop, 100, 1100);
  expect_only(Injection::sensor_drop, 100, 1100, 5000.0);
  expect_only(Injection::stall, 1, 501);
}

TEST(FaultyDevice, WhatIsUnpluggedIsGoneAndItsSamplesAge) {
  for (const auto& [kind, end] : {std::pair(Injection::unplug, 5000), std::pair(Injection::replug, 510)}) {
    const Trial trial = tried(kind, 10 * kTick, 5000);
    for (int n = 10; n < end; ++n) {
      const DeviceSample& sample = trial.samples[static_cast<std::size_t>(n)];
      EXPECT_FALSE(sample.connected);
      EXPECT_EQ(sample.X_DH.p, Moving::pose(10).p);
      EXPECT_NEAR(sample.age, 1e-4 + (n - 9) * kTick, 1e-12);
    }
    // Its firmware lets the last command go.
    for (int n = 0; n < end; ++n) {
      const DeviceCommand& told = trial.told[static_cast<std::size_t>(n)];
      const double left = n < 10 ? 1 : held_fraction((n - 9) * kTick);
      EXPECT_DOUBLE_EQ(told.F_H_D.force.y(), left) << n;
      EXPECT_DOUBLE_EQ(told.effort[0], left) << n;
    }
  }
}

TEST(FaultyDevice, ASilentDeviceIsStillThereAndItsSamplesAge) {
  for (const Injection kind : {Injection::stall, Injection::short_read}) {
    const Trial trial = tried(kind, 10 * kTick, 20);
    for (int n = 10; n < 20; ++n) {
      const DeviceSample& sample = trial.samples[static_cast<std::size_t>(n)];
      EXPECT_TRUE(sample.connected);
      EXPECT_EQ(sample.X_DH.p, Moving::pose(10).p);
      EXPECT_NEAR(sample.age, 1e-4 + (n - 9) * kTick, 1e-12);
    }
    for (const DeviceCommand& told : trial.told) EXPECT_EQ(told.F_H_D.force.y(), 1);  // it still hears
  }
}

TEST(FaultyDevice, WhatComesLateIsAsOldAsItSays) {
  const Trial trial = tried(Injection::late_reply, 100 * kTick, 200);
  for (int n = 100; n < 200; ++n) {
    const DeviceSample& sample = trial.samples[static_cast<std::size_t>(n)];
    EXPECT_EQ(sample.X_DH.p, Moving::pose(n + 1 - 15).p) << n;
    EXPECT_NEAR(sample.age, 1e-4 + 15e-3, 1e-12);
  }
}

TEST(FaultyDevice, FrozenJumpedAndDroppedSayWhatIsWrongAsIfItWereRight) {
  const auto at = [](const Trial& trial, int n) { return trial.samples[static_cast<std::size_t>(n)]; };
  const DeviceSample frozen = at(tried(Injection::frozen, 0.01, 20), 15);
  EXPECT_EQ(frozen.X_DH.p, Moving::pose(10).p);
  EXPECT_EQ(frozen.age, 1e-4);
  const Trial jumped = tried(Injection::jump, 0.01, 10'000);
  EXPECT_TRUE(is_true(at(jumped, 9), 9));
  for (const int n : {10, 500, 9999})
    EXPECT_NEAR(at(jumped, n).X_DH.p.x(), Moving::pose(n + 1).p.x() + 0.05, 1e-12);
  EXPECT_EQ(at(tried(Injection::sensor_drop, 0.01, 20, 5000.0), 15).strip_ohm, kStripOpen);
  const DeviceSample turned = at(tried(Injection::sensor_drop, 0.01, 20), 15);
  EXPECT_EQ(turned.X_DH.q.coeffs(), Moving::pose(10).q.coeffs());
  EXPECT_EQ(turned.X_DH.p, Moving::pose(16).p);
  EXPECT_TRUE(std::isnan(at(tried(Injection::nan, 0.01, 20), 10).X_DH.p.y()));
  EXPECT_FALSE(at(tried(Injection::write_fail, 0.01, 20), 10).connected);
}

TEST(FaultyDevice, NonsenseIsTheSameEveryTimeAndNoPoseOfTheHandle) {
  const Trial one = tried(Injection::garbage, 0.01, 20), other = tried(Injection::garbage, 0.01, 20);
  for (std::size_t n = 10; n < 15; ++n) {
    EXPECT_EQ(one.samples[n].X_DH.p, other.samples[n].X_DH.p);
    EXPECT_TRUE(one.samples[n].X_DH.is_finite());
    EXPECT_GT((one.samples[n].X_DH.p - Moving::pose(static_cast<int>(n) + 1).p).norm(), 0.1);
  }
}

TEST(FaultyDevice, TicksThatWereLostCount) {
  std::vector<DeviceCommand> told;
  auto moving = std::make_unique<Moving>(kNan, told);
  const Moving& inner = *moving;
  FaultyDevice device(std::move(moving), {Injection::nan, 0.1}, kTick);
  for (int n = 0; n < 50; ++n) EXPECT_TRUE(device.read().X_DH.is_finite());
  device.miss(50);
  EXPECT_EQ(inner.missed, 50);
  EXPECT_FALSE(device.read().X_DH.is_finite());
  EXPECT_TRUE(device.read().X_DH.is_finite());
}

TEST(InjectedFault, IsReadOrRefusedWithASentence) {
  for (const std::string_view name : names_of<Injection>) {
    const Result<InjectedFault> fault = read_injected_fault(std::string(name) + "@0.25");
    ASSERT_TRUE(fault) << name;
    EXPECT_EQ(name_of(fault->kind), name);
    EXPECT_EQ(fault->at, 0.25);
  }
  for (const char* text :
       {"", "@1", "nan@", "nan@x", "nan@1s", "nan@-1", "nan@nan", "nan@inf", "Nan@1", "nan @1"})
    EXPECT_FALSE(read_injected_fault(text)) << text;
  EXPECT_NE(read_injected_fault("nann@1").error().sentence.find("late-reply"), std::string::npos);
  EXPECT_NE(read_injected_fault("nan").error().sentence.find("nan@1.5"), std::string::npos);
}

// There was no pose before it: the first one is kept, not a nought that no handle was at.
TEST(FaultyDevice, AFaultFromTheStartKeepsTheFirstPose) {
  for (const Injection kind :
       {Injection::frozen, Injection::unplug, Injection::stall, Injection::late_reply}) {
    const Trial trial = tried(kind, 0, 10);
    for (const DeviceSample& sample : trial.samples)
      EXPECT_EQ(sample.X_DH.p, Moving::pose(1).p) << name_of(kind);
  }
}

}  // namespace
}  // namespace fulcrum
