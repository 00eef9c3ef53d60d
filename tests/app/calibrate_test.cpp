// What a calibration measures, of handles whose weight, friction and reach are known.

#include "engine/app/device_test/calibrate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "tests/app/tested_devices.h"

namespace fulcrum::test {
namespace {

// A free handle that gravity pulls at, and a hand or a table that may hold it.
class Weighty final : public Device {
public:
  Weighty(const DeviceDesc& desc, double weight)
      : weight_(weight), device_({.device = desc, .tick_s = kTick}, Pose{}) {}
  const DeviceDesc& desc() const override { return device_.desc(); }
  DeviceSample read() noexcept override { return device_.read(); }
  void write(const DeviceCommand& command) noexcept override {
    most = std::max(most, command.F_H_D.force.norm());
    last = command.F_H_D;
    DeviceCommand pulled = command;
    pulled.F_H_D.force.y() -= weight_;
    if (holds) pulled.F_H_D.force += holds(device_.X_DH().p, ticks);
    device_.write(pulled);
    farthest = std::max(farthest, device_.X_DH().p.norm());
    ++ticks;
  }
  void miss(int) noexcept override {}

  std::function<Vec3(const Vec3& p_D, int tick)> holds;
  double most = 0, farthest = 0;
  Wrench last;
  int ticks = 0;

private:
  double weight_;
  SimulatedDevice device_;
};

struct Measured {
  scenario::Calibration calibration{.device = "arm"};
  dt::Findings findings;
};

Measured calibrate_alone(Device& device) {
  dt::TestBench bench = bench_of(device);
  dt::NobodyThere nobody;
  Measured measured;
  measured.findings = dt::calibrate(bench, nobody, measured.calibration);
  return measured;
}

// In the middle until it is answered, and let go then.
Vec3 held_until_answered(const Vec3& p_D, int tick) {
  return tick < 700 ? Vec3(-50 * p_D) : Vec3(0, 0, 0);
}

// The bound stands in docs/held-devices.md, too.
TEST(Calibrate, WeighsWhatHangsOnTheHandle) {
  for (const double mass : {0.03, 0.1, 0.4}) {
    for (const double friction : {0.0, 0.04, 0.15, 0.26}) {
      for (const double weight : {0.0, 0.1, 0.3, 0.6}) {
        DeviceDesc desc = arm();
        desc.handle_mass = mass;
        desc.friction = friction;
        Weighty device(desc, weight);
        device.holds = held_until_answered;
        const Measured measured = calibrate_alone(device);
        const dt::Part& part = test::part(measured.findings, "weight");
        const std::string where = "mass " + std::to_string(mass) + ", friction " + std::to_string(friction) +
                                  ", weight " + std::to_string(weight);
        ASSERT_EQ(part.outcome, Outcome::good) << where << ": " << part.says;
        ASSERT_TRUE(measured.calibration.handle_weight);
        EXPECT_NEAR(*measured.calibration.handle_weight, weight, 0.005) << where;
        EXPECT_NEAR(measure(part, "friction"), friction, 0.02) << where;
        EXPECT_LE(device.most, 1 + 1e-12) << where;
        EXPECT_LT(device.farthest, 0.05) << where;
        EXPECT_TRUE(device.last.force.isZero(0)) << where;
      }
    }
  }
}

TEST(Calibrate, WhatPushesUpByItselfIsHeldUpByNothing) {
  Weighty device(arm(), -0.2);
  device.holds = held_until_answered;
  const Measured measured = calibrate_alone(device);
  EXPECT_EQ(measured.calibration.handle_weight, 0.0);
}

TEST(Calibrate, KeepsNoWeightOfAHandleThatIsHeld) {
  Weighty held(arm(), 0.3);
  held.holds = [](const Vec3& p_D, int) { return Vec3(-400 * p_D); };
  const Measured measured = calibrate_alone(held);
  EXPECT_EQ(part(measured.findings, "weight").outcome, Outcome::bad);
  EXPECT_NE(part(measured.findings, "weight").says.find("it was held"), std::string::npos)
      << part(measured.findings, "weight").says;
  EXPECT_FALSE(measured.calibration.handle_weight);
}

// A stop above or below, as near as 2 mm or nearly out of its way: what is kept is right, or nothing is kept.
TEST(Calibrate, KeepsNoWeightOfAHandleThatMeetsAStop) {
  int kept = 0;
  double worst = 0;
  for (const double mass : {0.03, 0.1, 0.4})
    for (const double friction : {0.0, 0.04, 0.15})
      for (const double weight : {0.0, 0.1, 0.3})
        for (const double stop : {-9.5e-3, -8e-3, -6e-3, -4e-3, -2e-3, 2e-3, 4e-3, 6e-3, 8e-3, 9.5e-3}) {
          DeviceDesc desc = arm();
          desc.handle_mass = mass;
          desc.friction = friction;
          Weighty device(desc, weight);
          device.holds = [stop](const Vec3& p_D, int tick) {
            const double beyond = stop > 0 ? std::max(0.0, p_D.y() - stop) : std::min(0.0, p_D.y() - stop);
            return Vec3(held_until_answered(p_D, tick) - 3000 * beyond * Vec3::UnitY());
          };
          const Measured measured = calibrate_alone(device);
          if (!measured.calibration.handle_weight) continue;
          ++kept;
          worst = std::max(worst, std::abs(*measured.calibration.handle_weight - weight));
        }
  std::printf("beside a stop: %d of 270 kept a weight, wrong by %.1f mN at most\n", kept, worst * 1e3);
  EXPECT_LT(worst, 0.02);
}

TEST(Calibrate, KeepsNoWeightThatChangesFromOneTimeToTheNext) {
  Weighty touched(arm(), 0.3);
  touched.holds = [](const Vec3&, int tick) { return Vec3(0, tick > 4500 ? 0.3 : 0.0, 0); };
  const Measured measured = calibrate_alone(touched);
  EXPECT_EQ(part(measured.findings, "weight").outcome, Outcome::bad);
  EXPECT_FALSE(measured.calibration.handle_weight);
}

TEST(Calibrate, KeepsNoWeightBeyondWhatItMayPushWith) {
  Weighty heavy(arm(), 1.3);
  heavy.holds = [](const Vec3& p_D, int) {
    return Vec3(0, p_D.y() < -0.02 ? 2000 * (-0.02 - p_D.y()) : 0, 0);
  };
  const Measured measured = calibrate_alone(heavy);
  EXPECT_EQ(part(measured.findings, "weight").outcome, Outcome::bad);
  EXPECT_NE(part(measured.findings, "weight").says.find("weighs more than 1 N"), std::string::npos)
      << part(measured.findings, "weight").says;
  EXPECT_FALSE(measured.calibration.handle_weight);
  EXPECT_LE(heavy.most, 1 + 1e-12);
}

// Its axes swapped or the wrong way round, or its samples late: it does not follow, and the force is let go
// before it has gone far.
class Astray final : public Device {
public:
  Astray(const DeviceDesc& desc, Mat3 seen, std::size_t late)
      : device_(desc, 0.3), seen_(std::move(seen)), late_(late) {}
  const DeviceDesc& desc() const override { return device_.desc(); }
  DeviceSample read() noexcept override {
    DeviceSample sample = device_.read();
    if (was_.empty()) from_ = sample.X_DH.p;
    sample.X_DH.p = from_ + seen_ * (sample.X_DH.p - from_);
    was_.push_back(sample);
    DeviceSample late = was_[was_.size() > late_ ? was_.size() - 1 - late_ : 0];
    late.age = static_cast<double>(late_) * kTick;
    return late;
  }
  void write(const DeviceCommand& command) noexcept override {
    pushed_for += command.F_H_D.force.norm() > 0.5 ? kTick : 0;
    device_.write(command);
  }
  void miss(int) noexcept override {}
  Weighty& device() { return device_; }

  double pushed_for = 0;  // s

private:
  Weighty device_;
  Mat3 seen_;
  std::size_t late_;
  std::vector<DeviceSample> was_;
  Vec3 from_ = Vec3::Zero();
};

TEST(Calibrate, AHandleThatDoesNotFollowIsLetGoAtOnce) {
  Mat3 swapped;
  swapped << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  const Mat3 inverted = Vec3(1, -1, 1).asDiagonal();
  struct Case {
    const char* name;
    Mat3 seen;
    std::size_t late;
  };
  for (const Case& c :
       {Case{"swapped", swapped, 0}, Case{"inverted", inverted, 0}, Case{"late", Mat3::Identity(), 19}}) {
    DeviceDesc desc = arm();
    desc.handle_mass = 0.045;
    Astray device(desc, c.seen, c.late);
    // A table below, and a hand that lets go as soon as it is to weigh itself.
    device.device().holds = [](const Vec3& p_D, int tick) {
      const double ground = p_D.y() < -0.05 ? 400 * (-0.05 - p_D.y()) : 0;
      return tick < 700 ? Vec3(-50 * p_D) : Vec3(0, ground, 0);
    };
    const Measured measured = calibrate_alone(device);
    const dt::Part& weight = part(measured.findings, "weight");
    EXPECT_EQ(weight.outcome, Outcome::bad) << c.name;
    EXPECT_NE(weight.says.find("did not follow"), std::string::npos) << c.name << ": " << weight.says;
    EXPECT_NE(weight.says.find("fulcrum device-test"), std::string::npos) << weight.says;
    EXPECT_FALSE(measured.calibration.handle_weight) << c.name;
    EXPECT_LT(device.pushed_for, 0.5) << c.name;
    EXPECT_TRUE(device.device().last.force.isZero(0)) << c.name;
  }
}

// A hand that goes to the ends of what it reaches while it is asked to, and answers as the test says.
struct Led {
  explicit Led(const DeviceDesc& desc) : device(desc) {
    person.on_ask = [this](const std::string& question) { moves = question.starts_with("Move the handle"); };
    device.on_read = [this](Played& played) {
      if (!moves) return;
      const double t = 0.001 * played.ticks;
      for (Eigen::Index i = 0; i < 3; ++i)
        played.sample.X_DH.p[i] = middle[i] + reach[i] * std::sin((5 + 2 * static_cast<double>(i)) * 10 * t);
    };
    person.says = [this](const std::string& question) {
      if (question.starts_with("Move the handle")) return Answer::yes;
      if (question.starts_with("Scenes are for the right hand")) return hand;
      return Answer::no;  // it is not to hold itself up
    };
  }
  Measured calibrate() {
    dt::TestBench bench = bench_of(device);
    Measured measured;
    measured.calibration.handle_weight = 0.2;  // as it was
    measured.findings = dt::calibrate(bench, person, measured.calibration);
    return measured;
  }

  Played device;
  Scripted person;
  Vec3 middle = Vec3(0.004, -0.01, 0), reach = Vec3(0.03, 0.04, 0.025);
  bool moves = false;
  Answer hand = Answer::no;
};

TEST(Calibrate, KeepsWhereAHandReachedAndWhichHandItWas) {
  Led led(arm());
  led.person.wait = 2000;
  led.hand = Answer::left;
  const Measured measured = led.calibrate();
  ASSERT_TRUE(measured.calibration.workspace) << part(measured.findings, "workspace").says;
  EXPECT_LT((measured.calibration.workspace->centre_D - led.middle).norm(), 1e-4);
  EXPECT_LT((measured.calibration.workspace->half_extents - led.reach).norm(), 1e-4);
  EXPECT_TRUE(measured.calibration.left_handed);
  EXPECT_EQ(part(measured.findings, "weight").outcome, Outcome::unknown);
  EXPECT_EQ(measured.calibration.handle_weight, 0.2) << "what was left out stays as it was";
  for (const DeviceCommand& command : led.device.told) EXPECT_TRUE(command.F_H_D.force.isZero(0));
}

TEST(Calibrate, AWorkspaceIsThatOfTheTableAtMost) {
  Led led(arm());
  led.person.wait = 2000;
  led.reach = Vec3(0.03, 0.09, 0.025);  // the table says 60 mm
  const Measured measured = led.calibrate();
  ASSERT_TRUE(measured.calibration.workspace);
  EXPECT_TRUE(scenario::calibrated(arm(), measured.calibration));
  EXPECT_NEAR(measured.calibration.workspace->half_extents.y(), 0.06, 1e-4);
}

TEST(Calibrate, AHandThatHardlyMovesLeavesNoWorkspace) {
  Led led(arm());
  led.person.wait = 2000;
  led.reach = Vec3(0.03, 0.004, 0.02);
  const Measured measured = led.calibrate();
  EXPECT_FALSE(measured.calibration.workspace);
  EXPECT_EQ(part(measured.findings, "workspace").outcome, Outcome::bad);
}

TEST(Calibrate, ADeviceWithoutMotorsIsAskedForTheHandAlone) {
  Led led(pad());
  const Measured measured = led.calibrate();
  ASSERT_EQ(led.person.asked.size(), 1U);
  EXPECT_FALSE(measured.calibration.workspace);
  EXPECT_FALSE(measured.calibration.left_handed);
}

TEST(Calibrate, TheHandIsWhatIsSaidWhateverItWas) {
  for (const bool left : {false, true})
    for (const Answer said : {Answer::left, Answer::right, Answer::no}) {
      Led led(pad());
      led.person.says = [said](const std::string&) { return said; };
      dt::TestBench bench = bench_of(led.device);
      scenario::Calibration calibration{.device = "pad", .left_handed = left};
      dt::calibrate(bench, led.person, calibration);
      EXPECT_EQ(calibration.left_handed, said == Answer::left || (said == Answer::no && left));
    }
}

TEST(Calibrate, WhoeverLeavesOutEverythingChangesNothing) {
  Led led(arm());
  led.person.says = [](const std::string&) { return Answer::no; };
  for (const bool left : {false, true}) {
    dt::TestBench bench = bench_of(led.device);
    scenario::Calibration calibration{.device = "arm", .left_handed = left};
    const dt::Findings findings = dt::calibrate(bench, led.person, calibration);
    EXPECT_EQ(calibration.left_handed, left);
    EXPECT_FALSE(calibration.workspace);
    EXPECT_FALSE(calibration.handle_weight);
    for (const dt::Part& each : findings.parts) EXPECT_EQ(each.outcome, Outcome::unknown) << each.name;
  }
}

TEST(Calibrate, ADeviceThatIsLostKeepsNothingAndIsLetGo) {
  Played device(arm());
  device.on_read = [](Played& d) {
    if (d.ticks > 2500) d.sample.connected = false;
  };
  const Measured measured = calibrate_alone(device);
  EXPECT_FALSE(measured.calibration.handle_weight);
  EXPECT_EQ(part(measured.findings, "the end").outcome, Outcome::bad);
  EXPECT_TRUE(device.told.back().F_H_D.force.isZero(0));
}

}  // namespace
}  // namespace fulcrum::test
