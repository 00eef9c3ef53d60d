// A strip's board by the real hidapi, on a node that umockdev stands in for, beside a device that moves.
// Whatever is waited for is waited for until it is seen: no clock decides.

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <mutex>
#include <thread>

#include "drivers/registry.h"
#include "tests/drivers_mock/mock_devices.h"

namespace fulcrum::test {
namespace {

constexpr hid::HidId kTestNumber{0x1209, 0x0001};

// One collection of this usage page; 64 bytes in, without a number: as docs/strip.md has it.
MockHidFacts strip_board(const std::string& name, std::uint8_t page_high = 0xFF) {
  return {.id = kTestNumber, .name = name, .descriptor = {0x06, 0x00, page_high, 0x09, 0x01, 0xA1, 0x01,
                                                          0x15, 0x00, 0x26,      0xFF, 0x00, 0x75, 0x08,
                                                          0x95, 0x40, 0x09,      0x01, 0x81, 0x02, 0xC0}};
}

// Reads its strip a thousand times a second, as its endpoint's interval has it, once what it said was taken.
class StripFirmware {
public:
  explicit StripFirmware(MockMachine& machine)
      : hid(machine, strip_board("Fulcrum strip")), runs_([this] { run(); }) {}
  ~StripFirmware() {
    on_ = false;
    runs_.join();
  }

  void plug(bool in) {
    const std::lock_guard lock(mutex_);
    plugged_ = in;
    in ? hid.plug() : hid.unplug();
  }

  MockHid hid;
  std::atomic<std::uint32_t> tenths_ohm{50500};

private:
  void run() {
    std::uint32_t number = 0;
    for (; on_; std::this_thread::sleep_for(std::chrono::milliseconds(1))) {
      const std::lock_guard lock(mutex_);
      if (!plugged_ || !hid.all_read()) continue;
      Bytes report{'F', 'S', 'T', '1'};
      ++number;
      for (const std::uint32_t word : {number, 1000 * number, tenths_ohm.load(), 0U})
        for (int byte = 0; byte < 4; ++byte)
          report.push_back(static_cast<std::uint8_t>(word >> 8 * byte & 255));
      report.resize(64);
      hid.say(report);
    }
  }

  std::mutex mutex_;  // it says nothing while it is being plugged in
  bool plugged_ = true;
  std::atomic<bool> on_{true};
  std::thread runs_;
};

class StripMock : public testing::Test {
protected:
  void SetUp() override { ASSERT_TRUE(machine.stands_in()) << "begin it by umockdev-wrapper"; }
  MockMachine machine;
};

DeviceListing listed_strip() {
  const std::vector<DeviceListing> devices = list_devices("");
  return *std::ranges::find(devices, "strip", &DeviceListing::name);
}

TEST_F(StripMock, ItIsReadBesideWhatMoves) {
  StripFirmware board(machine);
  EXPECT_TRUE(listed_strip().present) << listed_strip().reason;
  const auto open = open_device("keyboard+strip", {.desc = MouseDevice::mouse_desc(), .X_DH = Pose{}});
  ASSERT_TRUE(open) << open.error().sentence;
  ASSERT_NE(open->keys, nullptr) << "the window still talks to what moves";
  const auto wait_for_ohm = [&](auto seen) {
    wait_for([&] { return seen(open->device->read().strip_ohm); });
  };
  wait_for_ohm([](double ohm) { return std::abs(ohm - 5050) < 1e-6; });
  board.tenths_ohm = 0xFFFFFFFF;
  wait_for_ohm([](double ohm) { return ohm == kStripOpen; });
  board.tenths_ohm = 20000;
  wait_for_ohm([](double ohm) { return std::abs(ohm - 2000) < 1e-6; });
  open->keys->push({.way = {0, 1, 0}});
  for (int tick = 0; tick < 100; ++tick) open->device->read();
  EXPECT_GT(open->device->read().X_DH.p.y(), 0);

  for (int time = 0; time < 2; ++time) {
    board.plug(false);
    wait_for_ohm([](double ohm) { return std::isnan(ohm); });
    EXPECT_TRUE(open->device->read().connected) << "the handle is still there";
    board.plug(true);
    wait_for_ohm([](double ohm) { return std::abs(ohm - 2000) < 1e-6; });
  }
}

// The number is everybody's for tests at a desk of their own.
TEST_F(StripMock, AnotherBoardOfThatNumberIsNone) {
  MockHid blinker(machine, strip_board("Blinker"));
  MockHid joystick(machine, strip_board("Fulcrum strip", 0x00));
  EXPECT_FALSE(listed_strip().present);
  EXPECT_NE(listed_strip().reason.find("none is plugged in"), std::string::npos) << listed_strip().reason;
  StripFirmware board(machine);
  EXPECT_TRUE(listed_strip().present);
}

TEST_F(StripMock, OneThatSaysSomethingElseIsRefusedWithItsRemedy) {
  MockHid board(machine, strip_board("Fulcrum strip"));
  board.say(Bytes(64, 7));
  const auto open = open_device("keyboard+strip", {.desc = MouseDevice::mouse_desc(), .X_DH = Pose{}});
  ASSERT_FALSE(open);
  EXPECT_NE(open.error().sentence.find("docs/strip.md"), std::string::npos) << open.error().sentence;
}

}  // namespace
}  // namespace fulcrum::test
