// What the driver tells a DualSense is what Linux's own driver of it (hid-playstation) tells it for the same
// strengths: neither shares a line with the other, and the model of the pad shares none with either.

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "drivers/dualsense/dualsense_protocol.h"
#include "drivers/hid/hid_link.h"
#include "tests/device_models/dualsense_model.h"
#include "tests/device_models/usb_hid.h"
#include "tests/drivers_kernel/gamepad_rumble.h"
#include "tests/drivers_kernel/uhid_device.h"
#include "tests/drivers_kernel/usbip_device.h"
#include "tests/drivers_kernel/wait_for.h"

namespace fulcrum::test {
namespace {

using Bus = DualSenseModel::Bus;

struct RumbleCase {
  const char* name;
  Bus bus;
  std::uint16_t firmware;
};

// A pad in the kernel, by its cable or its radio.
class PluggedPad {
public:
  explicit PluggedPad(const RumbleCase& what)
      : pad(what.bus, what.firmware), usb_(pad, {UsbSpeed::high, 6, true}) {
    if (what.bus == Bus::usb)
      by_cable_.emplace(usb_);
    else
      by_radio_.emplace(pad);
  }
  DualSenseModel pad;

private:
  UsbHid usb_;
  std::optional<UsbipDevice> by_cable_;
  std::optional<UhidDevice> by_radio_;
};

class Rumble : public testing::TestWithParam<RumbleCase> {
protected:
  std::size_t flags() const { return GetParam().bus == Bus::usb ? 1 : 3; }
  std::size_t right() const { return flags() + 2; }
  std::size_t left() const { return flags() + 3; }

  // The first report of those from `after` on that has these strengths. meanwhile: done again and again.
  Bytes told(
      const DualSenseModel& pad, std::size_t after, int strong, int weak,
      const std::function<void()>& meanwhile = [] {}) const {
    Bytes found;
    wait_for([&] {
      meanwhile();
      const std::vector<Bytes> heard = pad.heard();
      for (std::size_t i = after; i < heard.size() && found.empty(); ++i)
        if ((heard[i].at(flags()) & 0x02) != 0 && heard[i].at(left()) == strong &&
            heard[i].at(right()) == weak)
          found = heard[i];
      return !found.empty();
    });
    return found;
  }

  void expect_whole(const Bytes& report) const {
    if (GetParam().bus == Bus::usb) return;
    ASSERT_EQ(report.size(), 78U);
    std::uint32_t crc = 0;
    for (std::size_t i = 0; i < 4; ++i) crc |= static_cast<std::uint32_t>(report[74 + i]) << (8 * i);
    EXPECT_EQ(crc, pad_crc(0xA2, std::span(report).first(74)));
  }

  // In hexadecimal digits, without what differs from report to report: by Bluetooth its count, and with it
  // the checksum.
  std::string bare(Bytes report) const {
    if (GetParam().bus == Bus::bluetooth) {
      report.resize(74);
      report[1] = 0;
    }
    std::string text;
    for (const std::uint8_t byte : report) {
      char digits[4];
      std::snprintf(digits, sizeof digits, "%02x ", byte);
      text += digits;
    }
    return text;
  }
};

std::unique_ptr<hid::HidLink> link_to_pad() {
  const auto places = hid::find_hid(dualsense::usb_ids());
  if (places.size() != 1) return nullptr;
  auto port = hid::open_hid(places[0]);
  if (!port) return nullptr;
  const sony::Link link = places[0].bluetooth ? sony::Link::bluetooth : sony::Link::usb;
  return std::make_unique<hid::HidLink>(
      hid::HidOpened{std::move(*port), std::make_unique<dualsense::DualSenseProtocol>(link)},
      [] { return hid::HidOpened{}; });
}

TEST_P(Rumble, IsToldAsLinuxsOwnDriverTellsIt) {
  PluggedPad plugged(GetParam());
  const DualSenseModel& pad = plugged.pad;
  std::unique_ptr<GamepadRumble> games;
  wait_for([&] { return (games = GamepadRumble::find()) != nullptr; });
  std::unique_ptr<hid::HidLink> ours;
  wait_for([&] { return (ours = link_to_pad()) != nullptr; });

  constexpr std::array<std::array<int, 2>, 5> kStrengths{
      {{255, 128}, {1, 255}, {77, 0}, {0, 200}, {255, 255}}};
  for (const auto& [strong, weak] : kStrengths) {
    std::size_t before = pad.heard().size();
    // Of 16 bits the pad takes the upper eight.
    ASSERT_TRUE(
        games->play(static_cast<std::uint16_t>(strong << 8 | 0x42), static_cast<std::uint16_t>(weak << 8)));
    const Bytes theirs = told(pad, before, strong, weak);
    ASSERT_TRUE(games->stop());
    told(pad, before, 0, 0);

    before = pad.heard().size();
    const Bytes own =
        told(pad, before, strong, weak,
             [&ours, drives = ChannelDrives{strong / 255.0, weak / 255.0}] { ours->drive(drives); });
    ours->drive({});
    told(pad, before, 0, 0);
    expect_whole(theirs);
    expect_whole(own);
    EXPECT_EQ(bare(own), bare(theirs)) << "left " << strong << ", right " << weak;
  }
  EXPECT_EQ(ours->refused(), 0U);
  EXPECT_GT(ours->reports(), 0U);
}

INSTANTIATE_TEST_SUITE_P(DualSense, Rumble,
                         testing::Values(RumbleCase{"UsbOlder", Bus::usb, 0x0100},
                                         RumbleCase{"UsbNewer", Bus::usb, 0x0224},
                                         RumbleCase{"BluetoothOlder", Bus::bluetooth, 0x0100},
                                         RumbleCase{"BluetoothNewer", Bus::bluetooth, 0x0224}),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace fulcrum::test
