// A strip's board by reports written by hand from docs/strip.md, from its bytes to where the hand holds.
// Whatever is waited for is waited for until it is seen: no clock decides.

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <deque>
#include <filesystem>
#include <mutex>
#include <thread>
#include <vector>

#include "drivers/force/force_device.h"
#include "drivers/strip/strip_bus.h"
#include "drivers/strip/strip_device.h"
#include "drivers/strip/strip_reports.h"
#include "engine/scenario/load.h"
#include "haptics/estimate/holding_point.h"

namespace fulcrum::test {
namespace {

using Bytes = std::vector<std::uint8_t>;
using strip::StripSays;
using Turn = ForceBus::Turn;

// docs/strip.md, "What it says": a mark, number, time in us, reading in tenths of an ohm, state.
Bytes strip_says(std::uint32_t number, std::uint32_t time_us, std::uint32_t reading,
                 std::uint32_t state = 0) {
  Bytes report{'F', 'S', 'T', '1'};
  for (const std::uint32_t word : {number, time_us, reading, state})
    for (int byte = 0; byte < 4; ++byte) report.push_back(static_cast<std::uint8_t>(word >> 8 * byte & 255));
  report.resize(64);
  return report;
}
constexpr std::uint32_t kNothingPresses = 0xFFFFFFFF;

TEST(Strip, AReportIsReadAsItIsWritten) {
  Bytes report{0x46, 0x53, 0x54, 0x31, 0x01, 0x02, 0x03, 0x84,
               0x10, 0x27, 0x00, 0x00, 0x39, 0x30, 0x00, 0x00};
  report.resize(64);
  const auto says = strip::decode(report);
  ASSERT_TRUE(says);
  EXPECT_EQ(says->number, 0x84030201U);
  EXPECT_EQ(says->time_us, 10000U);
  EXPECT_NEAR(says->ohm, 1234.5, 1e-9);
  for (std::size_t i = 12; i < 16; ++i) report[i] = 0xFF;
  EXPECT_EQ(strip::decode(report)->ohm, kStripOpen);
  report[16] = 1;
  EXPECT_TRUE(std::isnan(strip::decode(report)->ohm)) << "the board does not trust it";
  std::ranges::fill(report.begin() + 20, report.end(), std::uint8_t{0xAA});
  EXPECT_TRUE(strip::decode(report)) << "the rest is for later";
}

TEST(Strip, WhatIsNoReportIsRefused) {
  const Bytes good = strip_says(1, 2, 3);
  for (const std::size_t length : {0U, 3U, 4U, 20U, 63U})
    EXPECT_FALSE(strip::decode(std::span(good).first(length))) << length;
  Bytes longer = good;
  longer.push_back(0);
  EXPECT_FALSE(strip::decode(longer));
  for (std::size_t i = 0; i < 4; ++i) {
    Bytes other = good;
    ++other[i];
    EXPECT_FALSE(strip::decode(other)) << i;
  }
}

TEST(Strip, NumberAndTimeGoOnAndOver) {
  const auto follows = [](std::uint32_t n0, std::uint32_t t0, std::uint32_t n1, std::uint32_t t1) {
    return strip::follows({n0, t0, 0}, {n1, t1, 0});
  };
  EXPECT_TRUE(follows(1, 1000, 2, 2000));
  EXPECT_TRUE(follows(1, 1000, 400, 400000)) << "others were lost";
  EXPECT_TRUE(follows(0xFFFFFFFF, 0xFFFFFF00, 0, 0x100)) << "both run over";
  EXPECT_FALSE(follows(1, 1000, 1, 2000)) << "the same report";
  EXPECT_FALSE(follows(1, 1000, 2, 1000)) << "the same reading";
  EXPECT_FALSE(follows(1, 1000, 2, 900));
  EXPECT_FALSE(follows(5, 5000, 4, 6000));
  EXPECT_FALSE(follows(5000, 5000000, 1, 100)) << "it began anew: the next one tells";
}

// The board, and how it is plugged in.
struct StripBoard {
  std::mutex mutex;
  bool plugged = true;
  std::deque<Bytes> coming;
  std::uint32_t number = 0, time_us = 0;

  void say(Bytes report) {
    const std::lock_guard lock(mutex);
    coming.push_back(std::move(report));
  }
  void read_anew(std::uint32_t reading, std::uint32_t state = 0) {
    time_us += 1000;
    say(strip_says(++number, time_us, reading, state));
  }
  void plug(bool in) {
    const std::lock_guard lock(mutex);
    plugged = in;
    coming.clear();
  }
};

class StripBoardPort final : public hid::HidPort {
public:
  explicit StripBoardPort(StripBoard& board) : board_(board) {}
  int read(std::span<std::uint8_t> report, int) override {
    const std::lock_guard lock(board_.mutex);
    if (!board_.plugged) return -1;
    if (board_.coming.empty()) return 0;
    const Bytes next = board_.coming.front();
    board_.coming.pop_front();
    std::ranges::copy(next, report.begin());
    return static_cast<int>(next.size());
  }
  bool write(std::span<const std::uint8_t>) override {
    ADD_FAILURE() << "a strip is told nothing";
    return false;
  }
  int read_feature(std::span<std::uint8_t>) override { return -1; }

private:
  StripBoard& board_;
};

class StripBusTest : public testing::Test {
protected:
  Turn turn() { return bus.exchange({}, sample); }

  StripBoard board;
  strip::StripBus bus{std::make_unique<StripBoardPort>(board), DeviceDesc()};
  DeviceSample sample;
};

TEST_F(StripBusTest, AReadingCountsOnceAnotherOneWasBeforeIt) {
  EXPECT_EQ(turn(), Turn::none);
  EXPECT_EQ(bus.trouble(), "");
  board.read_anew(10000);
  EXPECT_EQ(turn(), Turn::none);
  board.read_anew(20000);
  EXPECT_EQ(turn(), Turn::fresh);
  EXPECT_NEAR(sample.strip_ohm, 2000, 1e-9);
  EXPECT_EQ(turn(), Turn::none);
  for (const std::uint32_t reading : {30000U, 40000U, 50000U}) board.read_anew(reading);
  EXPECT_EQ(turn(), Turn::fresh);
  EXPECT_NEAR(sample.strip_ohm, 5000, 1e-9) << "the newest";
  board.read_anew(kNothingPresses);
  EXPECT_EQ(turn(), Turn::fresh);
  EXPECT_EQ(sample.strip_ohm, kStripOpen);
  board.read_anew(20000, 1);
  EXPECT_EQ(turn(), Turn::fresh);
  EXPECT_TRUE(std::isnan(sample.strip_ohm));
  board.plug(false);
  EXPECT_EQ(turn(), Turn::lost);
}

TEST_F(StripBusTest, ReportsThatAreLostLeaveTheOthers) {
  board.read_anew(10000);
  board.number += 300, board.time_us += 300000;
  board.read_anew(20000);
  EXPECT_EQ(turn(), Turn::fresh);
  EXPECT_NEAR(sample.strip_ohm, 2000, 1e-9);
}

TEST_F(StripBusTest, WhatStandsStillIsNoReading) {
  board.read_anew(10000), board.read_anew(20000);
  EXPECT_EQ(turn(), Turn::fresh);
  const std::uint32_t number = board.number, time_us = board.time_us;
  board.say(strip_says(number, time_us, 30000));
  EXPECT_EQ(turn(), Turn::none) << "the same again";
  for (std::uint32_t later = 1; later < 10; ++later) board.say(strip_says(number + later, time_us, 30000));
  EXPECT_EQ(turn(), Turn::none) << "a reading of long ago";
  EXPECT_NEAR(sample.strip_ohm, 2000, 1e-9);
  EXPECT_NE(bus.trouble().find("stands still"), std::string::npos) << bus.trouble();
  board.number += 20;
  board.read_anew(40000);
  EXPECT_EQ(turn(), Turn::fresh) << "it goes on";
}

// One report of nonsense between others costs itself, and the next at most.
TEST_F(StripBusTest, NonsenseDoesNotLast) {
  for (const auto& [number, time_us] : {std::pair{0xFFFF0000U, 7U}, {7U, 0x7FFFFFFFU}, {0U, 0U}}) {
    board.read_anew(10000), board.read_anew(20000);
    board.say(strip_says(number, time_us, 90000));
    board.say(Bytes(64, 0xA5));
    board.say(Bytes(3, 'F'));
    turn();
    board.read_anew(30000), board.read_anew(40000);
    ASSERT_EQ(turn(), Turn::fresh) << number;
    EXPECT_NEAR(sample.strip_ohm, 4000, 1e-9);
  }
}

// hidraw keeps the oldest 63 and drops what is newer: how old the last of them is nobody knows.
TEST_F(StripBusTest, AsManyAsAreKeptAreOld) {
  for (std::uint32_t i = 0; i < 63; ++i) board.read_anew(10000 + i);
  EXPECT_EQ(turn(), Turn::none);
  board.read_anew(20000);
  EXPECT_EQ(turn(), Turn::fresh);
  EXPECT_NEAR(sample.strip_ohm, 2000, 1e-9);
}

TEST_F(StripBusTest, AForeignBoardIsSaid) {
  board.say(Bytes(64, 1));
  EXPECT_EQ(turn(), Turn::none);
  EXPECT_NE(bus.trouble().find("no strip's report"), std::string::npos) << bus.trouble();
}

// What a strip is fixed to.
class Handle final : public Device {
public:
  const DeviceDesc& desc() const override { return desc_; }
  DeviceSample read() noexcept override {
    DeviceSample sample;
    sample.X_DH.p = {0.1, 0.2, 0.3};
    sample.buttons = 5;
    sample.strip_ohm = 17;  // of its own strip, which the other one replaces
    sample.connected = connected;
    return sample;
  }
  void write(const DeviceCommand& command) noexcept override { written = command.effort[0]; }
  void miss(int ticks) noexcept override { missed += ticks; }

  bool connected = true;
  double written = 0;
  int missed = 0;

private:
  DeviceDesc desc_{.name = "handle"};
};

// The strip's figures as they are installed, its board in a thread of the test's, and the threads between.
class StripOnHandle : public testing::Test {
protected:
  void SetUp() override {
    const auto table =
        scenario::load_device(std::filesystem::path(FULCRUM_SOURCE_DIR) / "content/devices/strip.yaml");
    ASSERT_TRUE(table) << scenario::to_text(table.faults());
    ASSERT_TRUE(table->strip);
    figures = *table->strip;
    firmware = std::thread([this] {
      for (; runs; std::this_thread::sleep_for(std::chrono::milliseconds(1))) board.read_anew(reading);
    });
    auto opened = ForceDevice::start(DeviceDesc(), at_port(), [this] { return at_port(); });
    ASSERT_TRUE(opened) << opened.error().sentence;
    auto moves = std::make_unique<Handle>();
    handle = moves.get();
    device = std::make_unique<strip::StripDevice>(std::move(moves), std::move(*opened));
  }
  void TearDown() override {
    device.reset();
    runs = false;
    if (firmware.joinable()) firmware.join();
  }
  std::unique_ptr<ForceBus> at_port() {
    const std::lock_guard lock(board.mutex);
    if (!board.plugged) return nullptr;
    return std::make_unique<strip::StripBus>(std::make_unique<StripBoardPort>(board), DeviceDesc());
  }
  void wait_for(auto seen) {
    while (!seen(device->read().strip_ohm)) std::this_thread::yield();
  }

  HoldingStripDesc figures;
  StripBoard board;
  std::atomic<std::uint32_t> reading{50500};
  std::atomic<bool> runs{true};
  std::thread firmware;
  std::unique_ptr<Device> device;
  Handle* handle = nullptr;
};

TEST_F(StripOnHandle, ItsReadingIsOfTheSample) {
  wait_for([](double ohm) { return std::abs(ohm - 5050) < 1e-6; });
  const DeviceSample sample = device->read();
  EXPECT_EQ(sample.X_DH.p, Vec3(0.1, 0.2, 0.3));
  EXPECT_EQ(sample.buttons, 5U);
  EXPECT_EQ(device->desc().name, "handle");
  DeviceCommand command;
  command.effort[0] = 0.5;
  device->write(command);
  EXPECT_EQ(handle->written, 0.5);
  device->miss(3);
  EXPECT_EQ(handle->missed, 3);
  handle->connected = false;
  EXPECT_FALSE(device->read().connected);
}

// The handle is what a run cannot do without.
TEST_F(StripOnHandle, UnpluggedOrSilentItHasNoReadingAndTheHandleStaysThere) {
  for (int time = 0; time < 2; ++time) {
    wait_for([](double ohm) { return std::abs(ohm - 5050) < 1e-6; });
    board.plug(false);
    wait_for([](double ohm) { return std::isnan(ohm); });
    EXPECT_TRUE(device->read().connected);
    EXPECT_EQ(device->read().age, 0);
    board.plug(true);
  }
  wait_for([](double ohm) { return !std::isnan(ohm); });
  runs = false;
  wait_for([](double ohm) { return std::isnan(ohm); });
  EXPECT_TRUE(device->read().connected);
}

// From the finger to the point that the coupling is at: in ticks, which no clock counts.
TEST_F(StripOnHandle, WhereTheHandHoldsFollowsAndIsKeptWhereTheStripIsLost) {
  HoldingPoint holds({.place = 0.05}, figures, 1e-3);
  const auto tick_until = [&](HoldingState state, double place) {
    for (;;) {
      holds.update(device->read().strip_ohm);
      if (holds.state() == state && std::abs(holds.place() - place) < 1e-4) return;
      std::this_thread::yield();
    }
  };
  tick_until(HoldingState::measured, 0.1);  // 5050 ohm is the middle of 100 to 10000
  reading = 75250;
  tick_until(HoldingState::measured, 0.135);
  board.plug(false);
  wait_for([](double ohm) { return std::isnan(ohm); });
  tick_until(HoldingState::kept, 0.135);
  tick_until(HoldingState::lost, 0.05);
  board.plug(true);
  tick_until(HoldingState::measured, 0.135);
  reading = 150000;  // 15 kohm is beyond its end
  tick_until(HoldingState::lost, 0.05);
}

}  // namespace
}  // namespace fulcrum::test
