// Sony's pads by reports written by hand from Linux's hid-playstation.c; the checksum by the value that
// CRC-32 is known by, of the digits 1 to 9.

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <numbers>
#include <vector>

#include "drivers/dualsense/dualsense_protocol.h"
#include "drivers/dualshock4/dualshock4_protocol.h"
#include "drivers/hid/hid_bytes.h"
#include "drivers/rate/rate_control.h"
#include "haptics/math/rotation.h"

namespace fulcrum::test {
namespace {

using Bytes = std::vector<std::uint8_t>;
using hid::HidProtocol;
using sony::Link;

// Bit by bit, over the whole message: nothing of this is shared with the driver.
std::uint32_t plain_crc(const Bytes& message) {
  std::uint64_t remainder = 0;
  const auto bit_at = [&](std::size_t i) -> std::uint64_t {
    if (i >= 8 * message.size()) return 0;
    return message[i / 8] >> i % 8 & 1;
  };
  for (std::size_t i = 0; i < 8 * message.size() + 32; ++i) {
    remainder = remainder << 1 | (bit_at(i) ^ (i < 32 ? 1 : 0));
    if ((remainder >> 32 & 1) != 0) remainder ^= 0x104C11DB7;
  }
  std::uint32_t crc = 0;
  for (int bit = 0; bit < 32; ++bit) crc |= static_cast<std::uint32_t>(remainder >> bit & 1) << (31 - bit);
  return ~crc;
}

void put_crc(Bytes& report, std::uint8_t seed) {
  Bytes message(report.begin(), report.end() - 4);
  message.insert(message.begin(), seed);
  const std::uint32_t crc = plain_crc(message);
  for (std::size_t i = 0; i < 4; ++i) report[report.size() - 4 + i] = static_cast<std::uint8_t>(crc >> 8 * i);
}

bool sealed(const HidProtocol::Report& report) {
  Bytes bytes(report.begin(), report.begin() + 78);
  const Bytes sent = bytes;
  put_crc(bytes, 0xA2);
  return bytes == sent;
}

// Sticks and triggers at their middle, no key down.
constexpr std::array<std::uint8_t, 10> kDualSenseAtRest{128, 128, 128, 128, 0, 0, 0, 8, 0, 0};
constexpr std::array<std::uint8_t, 9> kDualShockAtRest{128, 128, 128, 128, 8, 0, 0, 0, 0};

template <std::size_t kCount>
Bytes report_of(std::size_t length, std::uint8_t number, std::size_t at,
                const std::array<std::uint8_t, kCount>& said) {
  Bytes report(length);
  report[0] = number;
  std::ranges::copy(said, report.begin() + static_cast<std::ptrdiff_t>(at));
  if (length == 78) put_crc(report, 0xA1);
  return report;
}

TEST(Pads, TheChecksumIsCrc32) {
  const Bytes digits{'2', '3', '4', '5', '6', '7', '8', '9'};
  EXPECT_EQ(hid::crc32('1', digits), 0xCBF43926U);
  EXPECT_EQ(plain_crc({'1', '2', '3', '4', '5', '6', '7', '8', '9'}), 0xCBF43926U);
}

TEST(DualSense, AtRestNothingIsPushed) {
  for (const Link link : {Link::usb, Link::bluetooth}) {
    dualsense::DualSenseProtocol pad(link);
    PushedAxes axes{Vec3::Ones(), Vec3::Ones(), 1};
    const Bytes report = link == Link::usb ? report_of(64, 0x01, 1, kDualSenseAtRest)
                                           : report_of(78, 0x31, 2, kDualSenseAtRest);
    ASSERT_TRUE(pad.decode(report, axes));
    EXPECT_TRUE(axes.rests());
    EXPECT_EQ(axes.buttons, 0U);
  }
}

TEST(DualSense, SticksTriggersAndKeysPushTheAxes) {
  dualsense::DualSenseProtocol pad(Link::usb);
  PushedAxes axes;
  // Left stick right and up, right stick left and down, R2 pulled, R1 and cross down.
  ASSERT_TRUE(pad.decode(
      report_of(64, 0x01, 1, std::to_array<std::uint8_t>({255, 0, 0, 255, 0, 255, 9, 0x28, 0x02, 0})), axes));
  EXPECT_EQ(axes.way, Vec3(1, 1, -1));
  EXPECT_EQ(axes.turn, Vec3(1, -1, -1));
  EXPECT_EQ(axes.buttons, 0x22U);
  // A worn stick that stays a tenth of its way off the middle is let go.
  ASSERT_TRUE(pad.decode(
      report_of(64, 0x01, 1, std::to_array<std::uint8_t>({140, 116, 128, 128, 20, 0, 9, 8, 0, 0})), axes));
  EXPECT_TRUE(axes.rests());
}

TEST(DualSense, OnBluetoothADamagedReportIsRefused) {
  dualsense::DualSenseProtocol pad(Link::bluetooth);
  const Bytes good = report_of(78, 0x31, 2, kDualSenseAtRest);
  for (std::size_t byte = 0; byte < good.size(); ++byte) {
    Bytes damaged = good;
    damaged[byte] ^= 0x10;
    PushedAxes axes{Vec3::Ones(), Vec3::Ones(), 1};
    EXPECT_FALSE(pad.decode(damaged, axes)) << byte;
    EXPECT_EQ(axes.way, Vec3::Ones()) << byte;
  }
  PushedAxes axes;
  EXPECT_FALSE(pad.decode(Bytes{}, axes));
  EXPECT_FALSE(pad.decode(Bytes{0x01, 128, 128, 128, 128, 8, 0, 0, 0, 0}, axes)) << "the reduced report";
  EXPECT_FALSE(pad.decode(Bytes(good.begin(), good.end() - 1), axes));
}

TEST(DualSense, LeftIsTheHeavyMotor) {
  dualsense::DualSenseProtocol pad(Link::usb);
  HidProtocol::Report report{};
  ASSERT_EQ(pad.encode({1, 0.5}, report), 63U);
  EXPECT_EQ(report[0], 0x02);
  EXPECT_EQ(report[1], 0x03);
  EXPECT_EQ(report[3], 128);
  EXPECT_EQ(report[4], 255);
  EXPECT_EQ(report[39], 0);
  pad.encode({std::numeric_limits<double>::quiet_NaN(), 7}, report);
  EXPECT_EQ(report[4], 0) << "what is no number is nothing";
  EXPECT_EQ(report[3], 255);
}

TEST(DualSense, NewerFirmwareIsToldInItsOwnWay) {
  dualsense::DualSenseProtocol pad(Link::usb);
  HidProtocol::Report report{};
  Bytes firmware(64);
  firmware[0] = 0x20;
  firmware[44] = 0x14, firmware[45] = 0x02;
  pad.learn(firmware);
  pad.encode({1, 1}, report);
  EXPECT_EQ(report[1], 0x03);
  firmware[44] = 0x15;
  pad.learn(firmware);
  pad.encode({1, 1}, report);
  EXPECT_EQ(report[1], 0x02);
  EXPECT_EQ(report[39], 0x04);
  pad.learn(Bytes{0x20});
  pad.learn(Bytes{});
}

TEST(DualSense, OnBluetoothEachReportIsCountedAndSealed) {
  dualsense::DualSenseProtocol pad(Link::bluetooth);
  for (int count = 0; count < 40; ++count) {
    HidProtocol::Report report{};
    ASSERT_EQ(pad.encode({0.2, 0}, report), 78U);
    EXPECT_EQ(report[0], 0x31);
    EXPECT_EQ(report[1], count % 16 << 4);
    EXPECT_EQ(report[2], 0x10);
    EXPECT_EQ(report[6], 51);
    EXPECT_TRUE(sealed(report)) << count;
  }
}

// (3) rad about right, up, toward the person, of a second of reports that all say this.
Vec3 turned_by(HidProtocol& pad, const Bytes& report) {
  RateControl tool({}, Pose(), 1e-3);
  PushedAxes axes;
  for (int tick = 0; tick < 1000; ++tick) {
    EXPECT_TRUE(pad.decode(report, axes));
    tool.advance(axes, {});
  }
  return rotation_vector(tool.X_WH().q);
}

void put_gyro(Bytes& report, std::size_t at, std::array<int, 3> readings) {
  for (std::size_t i = 0; i < 3; ++i) {
    report[at + 2 * i] = static_cast<std::uint8_t>(readings[i] & 255);
    report[at + 2 * i + 1] = static_cast<std::uint8_t>(readings[i] >> 8 & 255);
  }
}

Bytes with_crc(Bytes report) {
  if (report.size() == 78) put_crc(report, 0xA1);
  return report;
}

// A report at rest, where its gyroscope and the key of its touchpad are, and its pad.
struct TurnedPad {
  Bytes rests;
  std::size_t gyro, touchpad;
  std::unique_ptr<HidProtocol> pad;

  Bytes says(std::array<int, 3> readings, bool pressed) const {
    Bytes report = rests;
    put_gyro(report, gyro, readings);
    if (pressed) report[touchpad] |= 0x02;
    return with_crc(std::move(report));
  }
};

std::vector<TurnedPad> pads() {
  std::vector<TurnedPad> all;
  using dualsense::DualSenseProtocol, dualshock4::DualShock4Protocol;
  all.push_back(
      {report_of(64, 0x01, 1, kDualSenseAtRest), 16, 10, std::make_unique<DualSenseProtocol>(Link::usb)});
  all.push_back({report_of(78, 0x31, 2, kDualSenseAtRest), 17, 11,
                 std::make_unique<DualSenseProtocol>(Link::bluetooth)});
  all.push_back(
      {report_of(64, 0x01, 1, kDualShockAtRest), 13, 7, std::make_unique<DualShock4Protocol>(Link::usb)});
  all.push_back({report_of(78, 0x11, 3, kDualShockAtRest), 15, 9,
                 std::make_unique<DualShock4Protocol>(Link::bluetooth)});
  return all;
}

// 2000 deg/s are 32768. The tool follows with a lag of 15 ms.
TEST(Pads, WhileTheTouchpadIsPressedTheToolTurnsAsThePad) {
  constexpr double kReading = 2000.0 / 32768 * std::numbers::pi / 180, kLate = 1 - 0.015;
  for (const TurnedPad& each : pads()) {
    const Vec3 turned = turned_by(*each.pad, each.says({469, 0, 0}, true));
    EXPECT_NEAR(turned.x(), 469 * kReading * kLate, 2e-3);
    EXPECT_NEAR(turned.tail<2>().norm(), 0, 1e-9);
    EXPECT_NEAR(turned_by(*each.pad, each.says({0, -700, 0}, true)).y(), -700 * kReading * kLate, 2e-3);
    EXPECT_NEAR(turned_by(*each.pad, each.says({0, 0, 100}, true)).z(), 100 * kReading * kLate, 2e-3);
    EXPECT_TRUE(turned_by(*each.pad, each.says({469, -700, 100}, false)).isZero(0)) << "it is not pressed";
    EXPECT_LT(turned_by(*each.pad, each.says({32767, 0, 0}, true)).x(), 1.6);
    EXPECT_LT(turned_by(*each.pad, each.says({0, -32768, 0}, true)).y(), 0);
  }
}

TEST(Pads, WhatAGyroscopeIsOffByIsLearntAtRest) {
  for (const TurnedPad& each : pads()) {
    const Bytes off = each.says({40, -25, 10}, true);
    EXPECT_GT(turned_by(*each.pad, off).norm(), 0.03) << "not while it is in use";
    EXPECT_GT(turned_by(*each.pad, off).norm(), 0.03);
    turned_by(*each.pad, each.says({400, 0, 0}, false));  // that is a turn
    EXPECT_GT(turned_by(*each.pad, off).norm(), 0.03);
    for (int second = 0; second < 3; ++second) turned_by(*each.pad, each.says({40, -25, 10}, false));
    EXPECT_LT(turned_by(*each.pad, off).norm(), 1e-6);
    EXPECT_NEAR(turned_by(*each.pad, each.says({40 + 469, -25, 10}, true)).x(), 0.4924, 2e-3);
  }
}

TEST(DualShock4, SaysAndIsToldTheSameInItsOwnPlaces) {
  PushedAxes axes;
  dualshock4::DualShock4Protocol usb(Link::usb), bluetooth(Link::bluetooth);
  ASSERT_TRUE(usb.decode(report_of(64, 0x01, 1, kDualShockAtRest), axes));
  EXPECT_TRUE(axes.rests());
  ASSERT_TRUE(bluetooth.decode(
      report_of(78, 0x11, 3, std::to_array<std::uint8_t>({0, 128, 128, 128, 8, 0x01, 0, 255, 0})), axes));
  EXPECT_EQ(axes.way, Vec3(-1, 0, 1));
  EXPECT_EQ(axes.turn, Vec3(0, 0, 1));
  EXPECT_EQ(axes.buttons, 0x10U);

  HidProtocol::Report report{};
  ASSERT_EQ(usb.encode({1, 0.2}, report), 32U);
  EXPECT_EQ(report[0], 0x05);
  EXPECT_EQ(report[1], 0x01);
  EXPECT_EQ(report[4], 51);
  EXPECT_EQ(report[5], 255);
  ASSERT_EQ(bluetooth.encode({1, 0.2}, report), 78U);
  EXPECT_EQ(report[0], 0x11);
  EXPECT_EQ(report[1], 0xC0);
  EXPECT_EQ(report[3], 0x01);
  EXPECT_EQ(report[6], 51);
  EXPECT_EQ(report[7], 255);
  EXPECT_TRUE(sealed(report));
}

}  // namespace
}  // namespace fulcrum::test
