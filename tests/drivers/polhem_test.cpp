// A Polhem's bytes and geometry, against the formulas of its open interface written once more: nothing of
// them is shared with the driver, whose geometry is the device's table.

#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <numbers>
#include <vector>

#include "drivers/polhem/polhem_bus.h"
#include "engine/scenario/load.h"
#include "haptics/actuation/mechanism.h"
#include "haptics/math/rotation.h"
#include "haptics/math/split_mix.h"

namespace fulcrum::test {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Counts = std::array<int, 6>;
constexpr double kPi = std::numbers::pi;

DeviceDesc polhem_desc() {
  const auto device = scenario::load_device(std::filesystem::path(FULCRUM_SOURCE_DIR) / "content" /
                                            "devices" / "polhem.yaml");
  EXPECT_TRUE(device);
  return device ? *device : DeviceDesc();
}

// The interface's frame is x to the person, y right, z up; ours x right, y up, z to the person.
Vec3 ours(const Vec3& v) {
  return {v.y(), v.z(), v.x()};
}

struct Angles {
  double a, b, c;
};
Angles angles_of(const Counts& n) {
  const auto link = [](int count, double capstan, double body) {
    return -2 * kPi * count / 2000 * capstan / body;
  };
  return {link(n[0], 0.01, 0.18), link(n[1], 0.01, 0.1), link(n[2], 0.01, 0.1)};
}

// m, from the middle of the workspace.
Vec3 place_of(const Counts& n) {
  const auto [a, b, c] = angles_of(n);
  const double out = 0.174 * std::sin(b) + 0.133 * std::sin(c);
  return ours(
      {std::cos(a) * out - 0.14, std::sin(a) * out, 0.058 + 0.174 * std::cos(b) - 0.133 * std::cos(c) - 0.1});
}

Eigen::Matrix3d turn_of(const Counts& n) {
  using Eigen::AngleAxisd;
  const auto [a, b, c] = angles_of(n);
  const auto gimbal = [](int count, double sense) { return sense * 2 * kPi * count / 1024; };
  return (AngleAxisd(a, Vec3::UnitZ()) * AngleAxisd(kPi / 2 - c, Vec3::UnitY()) *
          AngleAxisd(gimbal(n[5], -1), Vec3::UnitX()) * AngleAxisd(gimbal(n[4], 1), Vec3::UnitY()) *
          AngleAxisd(gimbal(n[3], -1), Vec3::UnitX()))
      .toRotationMatrix();
}

// Anywhere in its workspace: yaw 46 deg to either side, links as its stops allow.
Counts any_counts(SplitMix& random) {
  const auto within = [&](int low, int high) {
    return low + static_cast<int>(random.uniform() * (high - low));
  };
  return {within(-4500, 4500), within(-3000, 1000), within(-3500, 1000),
          within(-200, 200),   within(-200, 200),   within(-400, 400)};
}

Bytes report_of(const Counts& n, int info = 0, bool button = false) {
  Bytes bytes;
  for (std::size_t i = 0; i < 7; ++i) {
    const int number = i == 6 ? info : n[i] + (button && i == 3 ? 10000 : 0);
    bytes.push_back(static_cast<std::uint8_t>(number & 255));
    bytes.push_back(static_cast<std::uint8_t>(number >> 8 & 255));
  }
  return bytes;
}

int number_in(std::span<const std::uint8_t> report, std::size_t i) {
  const int number = report[1 + 2 * i] + 256 * report[2 + 2 * i];
  return number < 32768 ? number : number - 65536;
}

TEST(Polhem, ThePoseIsThatOfTheInterfacesFormulas) {
  const polhem::PolhemArm arm(polhem_desc());
  SplitMix random(17);
  // Stylus and arm where the workspace has its middle: there the handle's axes are the device's.
  const auto home_count = [](double angle) {
    return static_cast<int>(std::lround(-angle * 10 * 2000 / (2 * kPi)));
  };
  const Counts home{0, home_count(0.4393498), home_count(0.5191672), 0, 0, 0};
  EXPECT_LT(arm.X_DH(home).p.norm(), 1e-4);
  const Eigen::Matrix3d at_home = turn_of(home);
  for (int n = 0; n < 1000; ++n) {
    const Counts counts = any_counts(random);
    const Pose X_DH = arm.X_DH(counts);
    EXPECT_NEAR((X_DH.p - place_of(counts)).norm(), 0, 1e-6);
    const Eigen::Matrix3d turned = turn_of(counts) * at_home.transpose();
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_NEAR((X_DH.q * ours(Vec3::Unit(axis)) - ours(turned.col(axis))).norm(), 0, 1e-3)
          << "a count of the home";
  }
}

// A motor that turns by a count does the work on the handle that its torque does on it: force times way
// there, current times constant times angle here. So signs and gears of currents are those of the counts.
TEST(Polhem, WhatTheMotorsDoIsWhatTheHandFeels) {
  const DeviceDesc desc = polhem_desc();
  const polhem::PolhemArm arm(desc);
  Mechanism mechanism(desc.mechanism);
  SplitMix random(4);
  for (int n = 0; n < 300; ++n) {
    const Counts counts = any_counts(random);
    mechanism.follow(arm.X_DH(counts));
    if (mechanism.out_of_reach() > 1e-6) continue;  // beyond a stop of the table
    for (std::size_t motor = 0; motor < 3; ++motor) {
      DeviceCommand command;
      for (std::size_t i = 0; i < 3; ++i) command.effort[i] = random.uniform() - 0.5;
      Vec3 force = Vec3::Zero();
      for (std::size_t i = 0; i < 3; ++i)
        force += command.effort[i] * mechanism.wrenches().col(static_cast<Eigen::Index>(i)).head<3>();
      Counts before = counts, after = counts;
      before[motor] -= 5;
      after[motor] += 5;
      const double at_handle = force.dot(place_of(after) - place_of(before));
      const double current = 1e-3 * arm.currents(command)[motor];
      const double at_motor = current * 0.0538 * 10 * 2 * kPi / 2000;
      EXPECT_NEAR(at_motor, at_handle, 0.01 * std::abs(at_handle) + 2e-6) << motor;
    }
  }
}

TEST(Polhem, CurrentsAreHeldToWhatTheMotorsTake) {
  const polhem::PolhemArm arm(polhem_desc());
  DeviceCommand command;
  for (const double effort : {100.0, -100.0, std::numeric_limits<double>::infinity()}) {
    command.effort[0] = command.effort[1] = command.effort[2] = effort;
    for (const int mA : arm.currents(command)) EXPECT_EQ(std::abs(mA), 2000);
  }
  EXPECT_EQ(arm.currents({}), (std::array<int, 3>{}));
  command.effort = {1, std::numeric_limits<double>::quiet_NaN(), 1};
  EXPECT_EQ(arm.currents(command), (std::array<int, 3>{})) << "nothing of what is no number";
}

TEST(Polhem, ReportsAreReadAndWrittenAsTheFirmwareHasThem) {
  const Counts counts{1, -2, 300, -400, 32000, -32768};
  const auto says = polhem::decode(report_of(counts, 1));
  ASSERT_TRUE(says);
  EXPECT_EQ(says->counts, counts);
  EXPECT_TRUE(says->asks_calibration);
  EXPECT_FALSE(says->button);
  const auto pressed = polhem::decode(report_of(counts, 0, true));
  EXPECT_EQ(pressed->counts, counts);
  EXPECT_TRUE(pressed->button);
  for (const std::size_t length : {0U, 1U, 8U, 13U, 15U, 64U})
    EXPECT_FALSE(polhem::decode(Bytes(length, 1))) << length;

  const auto currents = polhem::encode_currents({1000, -2000, 40000});
  ASSERT_EQ(currents.size(), 15u);
  EXPECT_EQ(currents[0], 0) << "no number";
  EXPECT_EQ(number_in(currents, 0), 1000);
  EXPECT_EQ(number_in(currents, 1), -2000);
  EXPECT_EQ(number_in(currents, 2), 32767);
  for (std::size_t i = 3; i < 7; ++i) EXPECT_EQ(number_in(currents, i), 0);
  const auto calibration = polhem::encode_calibration({1, 2, 3, 4, 5, 6});
  const int expected[] = {4, 5, 6, 1, 1, 2, 3};
  for (std::size_t i = 0; i < 7; ++i) EXPECT_EQ(number_in(calibration, i), expected[i]) << i;
}

// The board of the firmware: it answers what it hears with its counts.
class Board final : public hid::HidPort {
public:
  int read(std::span<std::uint8_t> report, int) override {
    if (!plugged) return -1;
    if (says.empty()) return 0;
    const Bytes next = says.front();
    says.pop_front();
    std::ranges::copy(next, report.begin());
    return static_cast<int>(next.size());
  }
  bool write(std::span<const std::uint8_t> report) override {
    if (!plugged || !takes) return false;
    heard.emplace_back(report.begin(), report.end());
    if (number_in(heard.back(), 3) == 1) {
      counts = {number_in(heard.back(), 4), number_in(heard.back(), 5), number_in(heard.back(), 6),
                number_in(heard.back(), 0), number_in(heard.back(), 1), number_in(heard.back(), 2)};
      asks = 0;
    }
    says.push_back(report_of(counts, asks));
    return true;
  }
  int read_feature(std::span<std::uint8_t>) override { return -1; }

  Counts counts{};
  int asks = 0;
  bool plugged = true, takes = true;
  std::deque<Bytes> says;
  std::vector<Bytes> heard;
};

struct OnBoard {
  Board* board;
  polhem::PolhemBus bus;
  explicit OnBoard(std::unique_ptr<Board> b) : board(b.get()), bus(std::move(b), polhem_desc()) {}
};

TEST(Polhem, UntilItIsCalibratedItIsNotPushedWith) {
  OnBoard polhem(std::make_unique<Board>());
  DeviceSample sample;
  DeviceCommand push;
  push.effort[0] = 1;
  for (int n = 0; n < 10; ++n) EXPECT_EQ(polhem.bus.exchange(push, sample), ForceBus::Turn::none);
  EXPECT_NE(polhem.bus.trouble().find("press the button"), std::string::npos);
  polhem.board->counts = {300, -40, 7, 0, 0, 0};  // its arm was moved since it was switched on
  for (int n = 0; n < 10; ++n) EXPECT_EQ(polhem.bus.exchange(push, sample), ForceBus::Turn::none);
  for (const Bytes& heard : polhem.board->heard)
    for (std::size_t i = 0; i < 7; ++i) EXPECT_EQ(number_in(heard, i), 0);
  polhem.board->asks = 1;  // the button
  EXPECT_EQ(polhem.bus.exchange(push, sample), ForceBus::Turn::none);
  EXPECT_EQ(polhem.bus.exchange(push, sample), ForceBus::Turn::fresh);
  EXPECT_EQ(polhem.board->counts, (Counts{0, 0, -5000, 0, 0, 0}));
  EXPECT_NEAR((sample.X_DH.p - place_of({0, 0, -5000, 0, 0, 0})).norm(), 0, 1e-6);
  EXPECT_EQ(number_in(polhem.board->heard.back(), 3), 1) << "the calibration itself pushes nothing";
  EXPECT_EQ(polhem.bus.exchange(push, sample), ForceBus::Turn::fresh);
  EXPECT_EQ(number_in(polhem.board->heard.back(), 0), -1033) << "mA: 1 N m over 18 turns and 0.0538 N m/A";
}

void calibrate(OnBoard& polhem) {
  DeviceSample sample;
  polhem.board->asks = 1;
  EXPECT_EQ(polhem.bus.exchange({}, sample), ForceBus::Turn::none);
  EXPECT_EQ(polhem.bus.exchange({}, sample), ForceBus::Turn::fresh);
}

TEST(Polhem, TheNewestOfWhatWaitsCounts) {
  OnBoard polhem(std::make_unique<Board>());
  calibrate(polhem);
  polhem.board->counts = {10, 20, -4000, 0, 0, 0};
  for (int n = 0; n < 5; ++n) polhem.board->says.push_back(report_of({n, 0, -3000, 0, 0, 0}));
  DeviceSample sample;
  ASSERT_EQ(polhem.bus.exchange({}, sample), ForceBus::Turn::fresh);
  EXPECT_NEAR((sample.X_DH.p - place_of({10, 20, -4000, 0, 0, 0})).norm(), 0, 1e-6);
}

TEST(Polhem, LostRefusedAndForeignAreSaid) {
  OnBoard polhem(std::make_unique<Board>());
  calibrate(polhem);
  polhem.board->counts = {1, 0, -5000, 0, 0, 0};
  DeviceSample sample;
  EXPECT_EQ(polhem.bus.exchange({}, sample), ForceBus::Turn::fresh);
  polhem.board->takes = false;
  polhem.board->says.push_back(report_of(polhem.board->counts));
  EXPECT_EQ(polhem.bus.exchange({}, sample), ForceBus::Turn::lost) << "what cannot be told to rest";
  polhem.board->plugged = false;
  EXPECT_EQ(polhem.bus.exchange({}, sample), ForceBus::Turn::lost);

  auto foreign = std::make_unique<Board>();
  foreign->plugged = true;
  for (int n = 0; n < 64; ++n) foreign->says.push_back(Bytes(8, 1));
  OnBoard other(std::move(foreign));
  EXPECT_EQ(other.bus.exchange({}, sample), ForceBus::Turn::none);
  EXPECT_NE(other.bus.trouble().find("no Polhem's report"), std::string::npos) << other.bus.trouble();
}

}  // namespace
}  // namespace fulcrum::test
