#pragma once
// What the tests on emulated HID devices share: a machine of their own, devices that are plugged into it, and
// waiting. Whatever is waited for is waited for until it is seen: no clock decides.

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <span>
#include <thread>

#include "drivers/hid/hid_link.h"
#include "tests/drivers_mock/mock_hid.h"

namespace fulcrum::test {

inline constexpr hid::HidId kSpaceMouse{0x256f, 0xc635}, kDualSense{0x054c, 0x0ce6};
inline constexpr std::uint8_t kMouseUsage = 2, kGamepadUsage = 5, kKeyboardUsage = 6, kMultiAxisUsage = 8;

// One collection of a usage of the generic desktop, whose reports are numbered. They say that reports 1 and 2
// come and how long they are; what is in them hidapi does not ask.
Bytes descriptor(std::uint8_t usage);

MockHidFacts spacemouse();
// firmware: as feature report 0x20 has it; from 0x0215 on rumble is asked for in another way.
MockHidFacts dualsense(bool bluetooth, std::uint16_t firmware);

// What a SpaceMouse says.
inline const Bytes kRight{1, 0x5E, 0x01, 0, 0, 0, 0};           // 350
inline const Bytes kBackAndDown{1, 0, 0, 0xAF, 0, 0x5E, 0x01};  // 175, 350
inline const Bytes kTurned{2, 0x5E, 0x01, 0, 0, 0xA2, 0xFE};    // 350, 0, -350
inline const Bytes kMiddle{1, 0, 0, 0, 0, 0, 0};

void wait_for(auto seen) {
  while (!seen()) std::this_thread::yield();
}

// As a device that is held says the same again and again: what was said once is held to be over soon.
void say_until(MockHid& device, const Bytes& report, auto seen) {
  while (!seen()) {
    if (device.all_read()) device.say(report);
    std::this_thread::yield();
  }
}

// As the haptic thread does it: what is not renewed is let go.
void drive_until(hid::HidLink& link, const ChannelDrives& drives, auto seen) {
  wait_for([&] {
    link.drive(drives);
    return seen();
  });
}

// The first of these devices with its protocol, and again when it is plugged in again; null where none is.
std::unique_ptr<hid::HidLink> linked(std::span<const hid::HidId> ids);

class Mock : public testing::Test {
protected:
  void SetUp() override { ASSERT_TRUE(machine.stands_in()) << "begin it by umockdev-wrapper"; }
  MockMachine machine;
};

}  // namespace fulcrum::test
