// A DualSense by the real hidapi: what it is asked, what it is told, and what comes of it.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <thread>
#include <vector>

#include "drivers/dualsense/dualsense_protocol.h"
#include "tests/drivers_mock/mock_devices.h"

namespace fulcrum::test {
namespace {

// CRC-32 as zlib has it, written here once more: the driver's own cannot say that it is right.
std::uint32_t crc_of(std::uint8_t seed, const Bytes& bytes, std::size_t count) {
  std::uint32_t crc = 0xFFFFFFFF;
  for (std::size_t i = 0; i <= count; ++i) {
    crc ^= i == 0 ? seed : bytes[i - 1];
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 1) != 0 ? (crc >> 1) ^ 0xEDB88320 : crc >> 1;
  }
  return crc ^ 0xFFFFFFFF;
}

std::uint32_t crc_in(const Bytes& report) {
  std::uint32_t crc = 0;
  for (std::size_t i = 0; i < 4; ++i) crc |= static_cast<std::uint32_t>(report[74 + i]) << (8 * i);
  return crc;
}

// The left stick pushed to the right, all else at rest, from `sticks` on.
Bytes pushed_pad(std::uint8_t number, std::size_t length, std::size_t sticks) {
  Bytes report(length);
  report[0] = number;
  std::fill_n(report.begin() + static_cast<std::ptrdiff_t>(sticks), 4, std::uint8_t{128});
  report[sticks] = 255;
  report[sticks + 7] = 8;  // the cross is let go
  return report;
}

TEST_F(Mock, DualSenseByUsbIsAskedAndTold) {
  MockHid pad(machine, dualsense(false, 0x0100));
  {
    const auto link = linked(dualsense::usb_ids());
    ASSERT_NE(link, nullptr);
    EXPECT_EQ(pad.asked(), Bytes{0x20});
    pad.say(pushed_pad(0x01, 64, 1));
    wait_for([&] { return link->read().axes.way == Vec3(1, 0, 0); });
    drive_until(*link, {1, 0.5}, [&] { return !pad.written().empty(); });
    const Bytes told = pad.written().front();
    ASSERT_EQ(told.size(), 63U);
    EXPECT_EQ(told[0], 0x02);
    EXPECT_EQ(told[1], 0x03) << "older firmware is asked for rumble so";
    EXPECT_EQ(told[3], 128) << "right";
    EXPECT_EQ(told[4], 255) << "left";
  }
  const Bytes last = pad.written().back();
  EXPECT_EQ(last[3] | last[4], 0) << "the motors rest at the end";
}

TEST_F(Mock, DualSenseByBluetoothIsAskedAndTold) {
  MockHid pad(machine, dualsense(true, 0x0224));
  const auto link = linked(dualsense::usb_ids());
  ASSERT_NE(link, nullptr);
  EXPECT_EQ(pad.asked(), (Bytes{0x20, 0x05}));
  Bytes report = pushed_pad(0x31, 78, 2);
  pad.say(report);  // its checksum is wrong
  wait_for([&] { return link->refused() == 1; });
  const std::uint32_t crc = crc_of(0xA1, report, 74);
  for (std::size_t i = 0; i < 4; ++i) report[74 + i] = static_cast<std::uint8_t>(crc >> (8 * i));
  pad.say(report);
  wait_for([&] { return link->read().axes.way == Vec3(1, 0, 0); });
  drive_until(
      *link, {1, 0.5}, [&] { return !pad.written().empty(); });
  drive_until(*link, {0.5, 1}, [&] { return pad.last_written()[5] == 255; });
  const std::vector<Bytes> told = pad.written();
  EXPECT_EQ(told.front()[5], 128) << "right";
  EXPECT_EQ(told.front()[6], 255) << "left";
  EXPECT_EQ(told.back()[6], 128) << "left";
  for (std::size_t i = 0; i < told.size(); ++i) {
    ASSERT_EQ(told[i].size(), 78U);
    EXPECT_EQ(told[i][0], 0x31);
    EXPECT_EQ(told[i][1], (i & 15) << 4) << "they are counted";
    EXPECT_EQ(told[i][3], 0x02) << "newer firmware is asked for rumble so";
    EXPECT_EQ(told[i][41], 0x04) << "and so";
    EXPECT_EQ(crc_in(told[i]), crc_of(0xA2, told[i], 74));
  }
}

TEST_F(Mock, AFeatureThatStallsIsDoneWithout) {
  MockHidFacts facts = dualsense(true, 0);
  facts.features.clear();
  MockHid pad(machine, facts);
  const auto link = linked(dualsense::usb_ids());
  ASSERT_NE(link, nullptr);
  EXPECT_EQ(pad.asked(), (Bytes{0x20, 0x05}));
  EXPECT_TRUE(link->read().connected);
  drive_until(*link, {1, 1}, [&] { return !pad.written().empty(); });
  EXPECT_EQ(pad.written().front()[3], 0x03) << "it is taken for the older one";
  Bytes report = pushed_pad(0x31, 78, 2);
  const std::uint32_t crc = crc_of(0xA1, report, 74);
  for (std::size_t i = 0; i < 4; ++i) report[74 + i] = static_cast<std::uint8_t>(crc >> (8 * i));
  pad.say(report);
  wait_for([&] { return link->read().axes.way == Vec3(1, 0, 0); });
}

TEST_F(Mock, APadThatComesBackIsAskedAndToldAgain) {
  MockHid pad(machine, dualsense(false, 0x0224));
  const auto link = linked(dualsense::usb_ids());
  ASSERT_NE(link, nullptr);
  drive_until(*link, {1, 0}, [&] { return !pad.written().empty(); });
  pad.unplug();
  wait_for([&] { return !link->read().connected; });
  const std::size_t before = pad.written().size();
  pad.plug();
  wait_for([&] { return link->read().connected; });
  drive_until(*link, {1, 0}, [&] { return pad.written().size() > before && pad.last_written()[4] == 255; });
  EXPECT_EQ(pad.asked(), (Bytes{0x20, 0x20}));
}

// The haptic thread stands still, or has ended.
TEST_F(Mock, WhatNobodyRenewsVibratesNoLonger) {
  MockHid pad(machine, dualsense(false, 0x0224));
  const auto link = linked(dualsense::usb_ids());
  ASSERT_NE(link, nullptr);
  drive_until(
      *link, {1, 1}, [&] { return !pad.written().empty() && pad.last_written()[4] == 255; });
  wait_for([&] { return pad.last_written()[4] == 0 && pad.last_written()[3] == 0; });
}

// A pad may refuse what it is told for as long as it likes: what it says is read all the same.
TEST_F(Mock, APadThatRefusesWhatItIsToldIsStillRead) {
  MockHid pad(machine, dualsense(false, 0x0224));
  const auto link = linked(dualsense::usb_ids());
  ASSERT_NE(link, nullptr);
  pad.take(false);
  say_until(pad, pushed_pad(0x01, 64, 1), [&] {
    link->drive({1, 1});
    return link->reports() >= 1000;
  });
  EXPECT_TRUE(link->read().connected);
  EXPECT_TRUE(pad.written().empty());
  pad.take(true);
  drive_until(*link, {1, 1}, [&] { return !pad.written().empty() && pad.last_written()[4] == 255; });
}

// hidapi keeps what went wrong last with a device, and each call frees it.
TEST_F(Mock, WritesThatFailWhileReportsAreReadHarmNothing) {
  MockHid pad(machine, dualsense(false, 0));
  pad.take(false);
  const auto places = hid::find_hid(dualsense::usb_ids());
  ASSERT_EQ(places.size(), 1U);
  const auto port = hid::open_hid(places[0]);
  ASSERT_TRUE(port) << port.error().sentence;
  std::atomic<bool> ends = false;
  std::thread writer([&] {
    const Bytes report(63, 2);
    for (int count = 0; count < 20000; ++count) EXPECT_FALSE((*port)->write(report));
    ends = true;
  });
  std::array<std::uint8_t, 64> bytes{};
  while (!ends) EXPECT_EQ((*port)->read(bytes, 0), 0);
  writer.join();
}

}  // namespace
}  // namespace fulcrum::test
