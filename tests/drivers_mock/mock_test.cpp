// The drivers by the real hidapi and libudev, on devices that umockdev stands in for. Whatever is waited for
// is waited for until it is seen: no clock decides.

#include <gtest/gtest.h>
#include <linux/capability.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "drivers/dualsense/dualsense_protocol.h"
#include "drivers/hid/hid_link.h"
#include "drivers/registry.h"
#include "drivers/spacemouse/spacemouse_protocol.h"
#include "tests/drivers_mock/mock_hid.h"

namespace fulcrum::test {
namespace {

constexpr hid::HidId kSpaceMouse{0x256f, 0xc635}, kCadMouse{0x256f, 0xc650}, kDualSense{0x054c, 0x0ce6};

// One collection of a usage of the generic desktop, whose reports are numbered. They say that reports 1 and 2
// come and how long they are; what is in them hidapi does not ask.
Bytes descriptor(std::uint8_t usage) {
  return {0x05, 0x01, 0x09, usage, 0xA1, 0x01,                          // generic desktop, usage, application
          0x85, 0x01, 0x09, 0x30,  0x75, 0x08, 0x95, 0x06, 0x81, 0x02,  // report 1: six bytes in
          0x85, 0x02, 0x09, 0x33,  0x75, 0x08, 0x95, 0x06, 0x81, 0x02, 0xC0};
}
constexpr std::uint8_t kMouseUsage = 2, kGamepadUsage = 5, kKeyboardUsage = 6, kMultiAxisUsage = 8;

MockHidFacts spacemouse() {
  return {.id = kSpaceMouse, .name = "SpaceMouse Compact", .descriptor = descriptor(kMultiAxisUsage)};
}

// Its firmware's version, as feature report 0x20 has it; from 0x0215 on rumble is asked for in another way.
MockHidFacts dualsense(bool bluetooth, std::uint16_t firmware) {
  Bytes version(64), calibration(41);
  version[0] = 0x20;
  version[44] = static_cast<std::uint8_t>(firmware & 0xFF);
  version[45] = static_cast<std::uint8_t>(firmware >> 8);
  calibration[0] = 0x05;
  return {.id = kDualSense,
          .bluetooth = bluetooth,
          .name = "Wireless Controller",
          .descriptor = descriptor(kGamepadUsage),
          .features = {version, calibration}};
}

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

const Bytes kRight{1, 0x5E, 0x01, 0, 0, 0, 0};           // 350
const Bytes kBackAndDown{1, 0, 0, 0xAF, 0, 0x5E, 0x01};  // 175, 350
const Bytes kTurned{2, 0x5E, 0x01, 0, 0, 0xA2, 0xFE};    // 350, 0, -350
const Bytes kMiddle{1, 0, 0, 0, 0, 0, 0};

class Mock : public testing::Test {
protected:
  void SetUp() override { ASSERT_TRUE(machine.stands_in()) << "begin it by umockdev-wrapper"; }
  MockMachine machine;
};

hid::HidOpened opened(std::span<const hid::HidId> ids) {
  const std::vector<hid::HidPlace> places = hid::find_hid(ids);
  if (places.empty()) return {};
  auto port = hid::open_hid(places.front());
  if (!port) return {};
  const sony::Link link = places.front().bluetooth ? sony::Link::bluetooth : sony::Link::usb;
  if (places.front().id == kDualSense)
    return {std::move(*port), std::make_unique<dualsense::DualSenseProtocol>(link)};
  return {std::move(*port), std::make_unique<SpaceMouseProtocol>()};
}

std::unique_ptr<hid::HidLink> linked(std::span<const hid::HidId> ids) {
  hid::HidOpened now = opened(ids);
  if (!now.port) return nullptr;
  return std::make_unique<hid::HidLink>(std::move(now), [ids] { return opened(ids); });
}

TEST_F(Mock, WithoutDevicesNoneIsFound) {
  EXPECT_TRUE(hid::find_hid(spacemouse_ids()).empty());
  for (const DeviceListing& device : list_devices(""))
    if (device.name == "spacemouse" || device.name == "dualsense") EXPECT_FALSE(device.present);
}

TEST_F(Mock, SpaceMouseIsFoundAndCadMouseIsNot) {
  MockHid cadmouse(machine, {.id = kCadMouse, .name = "CadMouse", .descriptor = descriptor(kMouseUsage)});
  EXPECT_TRUE(hid::find_hid(spacemouse_ids()).empty());
  MockHid mouse(machine, spacemouse());
  const std::vector<hid::HidPlace> places = hid::find_hid(spacemouse_ids());
  ASSERT_EQ(places.size(), 1U);
  EXPECT_EQ(places[0].id, kSpaceMouse);
  EXPECT_EQ(places[0].path, mouse.node());
  EXPECT_EQ(places[0].product, "SpaceMouse Compact");
  EXPECT_FALSE(places[0].bluetooth);
  EXPECT_TRUE(places[0].permitted);
  EXPECT_TRUE(hid::find_hid(dualsense::usb_ids()).empty());
}

// Some devices have a second node, which types.
TEST_F(Mock, ANodeThatReportsNoAxesIsPassedOver) {
  MockHidFacts keys = spacemouse();
  keys.descriptor = descriptor(kKeyboardUsage);
  MockHid keyboard(machine, keys);
  EXPECT_TRUE(hid::find_hid(spacemouse_ids()).empty());
  MockHid mouse(machine, spacemouse());
  const std::vector<hid::HidPlace> places = hid::find_hid(spacemouse_ids());
  ASSERT_EQ(places.size(), 1U);
  EXPECT_EQ(places[0].path, mouse.node());
}

TEST_F(Mock, TheBusIsKnown) {
  MockHid by_usb(machine, dualsense(false, 0)), by_bluetooth(machine, dualsense(true, 0));
  const std::vector<hid::HidPlace> places = hid::find_hid(dualsense::usb_ids());
  ASSERT_EQ(places.size(), 2U);
  for (const hid::HidPlace& place : places) {
    EXPECT_EQ(place.bluetooth, place.path == by_bluetooth.node()) << place.path;
    EXPECT_EQ(place.product, "Wireless Controller") << place.path;
  }
}

TEST_F(Mock, ReportsAreReadOneByOne) {
  MockHid mouse(machine, spacemouse());
  const auto places = hid::find_hid(spacemouse_ids());
  ASSERT_EQ(places.size(), 1U);
  const auto port = hid::open_hid(places[0]);
  ASSERT_TRUE(port) << port.error().sentence;
  std::array<std::uint8_t, 64> bytes{};
  EXPECT_EQ((*port)->read(bytes, 0), 0) << "it has said nothing";
  const std::vector<Bytes> all{kRight, kTurned, {3, 1, 0}, kMiddle};
  for (const Bytes& report : all) mouse.say(report);
  for (const Bytes& report : all) {
    const int length = (*port)->read(bytes, -1);
    ASSERT_EQ(length, static_cast<int>(report.size()));
    EXPECT_TRUE(std::equal(report.begin(), report.end(), bytes.begin()));
  }
  EXPECT_EQ((*port)->read(bytes, 0), 0);
}

TEST_F(Mock, AxesComeAsSent) {
  MockHid mouse(machine, spacemouse());
  const auto link = linked(spacemouse_ids());
  ASSERT_NE(link, nullptr);
  say_until(
      mouse, kRight, [&] { return link->read().axes.way == Vec3(1, 0, 0); });
  say_until(
      mouse, kBackAndDown, [&] { return link->read().axes.way == Vec3(0, -1, 0.5); });
  say_until(mouse, kTurned, [&] { return link->read().axes.turn == Vec3(1, 1, 0); });
  mouse.say({3, 2, 0});
  wait_for([&] { return link->read().axes.buttons == 2; });
  EXPECT_TRUE(link->read().connected);
  EXPECT_EQ(link->refused(), 0U);
}

TEST_F(Mock, DualSenseByUsbIsAskedAndTold) {
  MockHid pad(machine, dualsense(false, 0x0100));
  {
    const auto link = linked(dualsense::usb_ids());
    ASSERT_NE(link, nullptr);
    EXPECT_EQ(pad.asked(), Bytes{0x20});
    pad.say(pushed_pad(0x01, 64, 1));
    wait_for([&] { return link->read().axes.way == Vec3(1, 0, 0); });
    link->drive({1, 0.5});
    wait_for([&] { return !pad.written().empty(); });
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
  link->drive({1, 0.5});
  wait_for([&] { return pad.written().size() >= 2; });
  const std::vector<Bytes> told = pad.written();
  for (std::size_t i = 0; i < 2; ++i) {
    ASSERT_EQ(told[i].size(), 78U);
    EXPECT_EQ(told[i][0], 0x31);
    EXPECT_EQ(told[i][1], i << 4) << "they are counted";
    EXPECT_EQ(told[i][3], 0x02) << "newer firmware is asked for rumble so";
    EXPECT_EQ(told[i][41], 0x04) << "and so";
    EXPECT_EQ(told[i][5], 128) << "right";
    EXPECT_EQ(told[i][6], 255) << "left";
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
  link->drive({1, 1});
  wait_for([&] { return !pad.written().empty(); });
  EXPECT_EQ(pad.written().front()[3], 0x03) << "it is taken for the older one";
  Bytes report = pushed_pad(0x31, 78, 2);
  const std::uint32_t crc = crc_of(0xA1, report, 74);
  for (std::size_t i = 0; i < 4; ++i) report[74 + i] = static_cast<std::uint8_t>(crc >> (8 * i));
  pad.say(report);
  wait_for([&] { return link->read().axes.way == Vec3(1, 0, 0); });
}

// It comes back under another number, as Linux does it while the old one is still open.
TEST_F(Mock, UnpluggedItSaysSoAndPluggedInAgainItGoesOn) {
  MockHid mouse(machine, spacemouse());
  const auto link = linked(spacemouse_ids());
  ASSERT_NE(link, nullptr);
  for (int time = 0; time < 3; ++time) {
    say_until(mouse, kRight, [&] { return link->read().axes.way.x() == 1; });
    mouse.unplug();
    wait_for([&] { return !link->read().connected; });
    EXPECT_TRUE(hid::find_hid(spacemouse_ids()).empty());
    mouse.plug();
    wait_for([&] { return link->read().connected; });
    EXPECT_TRUE(link->read().axes.rests()) << "what was pushed before is not pushed now";
  }
  say_until(mouse, kTurned, [&] { return link->read().axes.turn == Vec3(1, 1, 0); });
}

TEST_F(Mock, APadThatComesBackIsAskedAndToldAgain) {
  MockHid pad(machine, dualsense(false, 0x0224));
  const auto link = linked(dualsense::usb_ids());
  ASSERT_NE(link, nullptr);
  link->drive({1, 0});
  wait_for([&] { return !pad.written().empty(); });
  pad.unplug();
  wait_for([&] { return !link->read().connected; });
  const std::size_t before = pad.written().size();
  pad.plug();
  wait_for([&] { return link->read().connected; });
  wait_for([&] { return pad.written().size() > before; });
  EXPECT_EQ(pad.asked(), (Bytes{0x20, 0x20}));
  EXPECT_EQ(pad.written().back()[4], 255) << "it vibrates still";
}

// A pad may refuse what it is told for as long as it likes: what it says is read all the same.
TEST_F(Mock, APadThatRefusesWhatItIsToldIsStillRead) {
  MockHid pad(machine, dualsense(false, 0x0224));
  const auto link = linked(dualsense::usb_ids());
  ASSERT_NE(link, nullptr);
  pad.take(false);
  link->drive({1, 1});
  say_until(pad, pushed_pad(0x01, 64, 1), [&] { return link->reports() >= 1000; });
  EXPECT_TRUE(link->read().connected);
  EXPECT_TRUE(pad.written().empty());
  pad.take(true);
  wait_for([&] { return !pad.written().empty(); });
  EXPECT_EQ(pad.written().front()[4], 255);
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

// Of a device that is being unplugged.
TEST_F(Mock, ANodeWithoutANameIsPassedOver) {
  MockHidFacts facts = spacemouse();
  facts.named = false;
  MockHid going(machine, facts);
  EXPECT_TRUE(hid::find_hid(spacemouse_ids()).empty());
}

TEST_F(Mock, ADeviceThatGoesWhileItIsOpenedIsNotOpened) {
  MockHid mouse(machine, spacemouse());
  const auto places = hid::find_hid(spacemouse_ids());
  ASSERT_EQ(places.size(), 1U);
  mouse.go();
  EXPECT_FALSE(hid::open_hid(places[0]));
  mouse.unplug();
  EXPECT_FALSE(hid::open_hid(places[0]));
}

// The person who runs the tests may be root, who may open everything. This thread gives that up for itself.
bool give_up_privileges() {
  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
  __user_cap_data_struct sets[2]{};
  if (syscall(SYS_capget, &header, sets) != 0) return false;
  constexpr std::uint32_t kOpenAll = 1U << CAP_DAC_OVERRIDE | 1U << CAP_DAC_READ_SEARCH;
  sets[0].effective &= ~kOpenAll;
  sets[0].permitted &= ~kOpenAll;
  return syscall(SYS_capset, &header, sets) == 0;
}

TEST_F(Mock, ANodeThatMayNotBeOpenedSaysWhatWouldCureIt) {
  MockHid mouse(machine, spacemouse());
  ASSERT_EQ(chmod(mouse.node().c_str(), 0), 0);
  bool forbidden = false;
  std::vector<hid::HidPlace> places;
  std::vector<DeviceListing> listings;
  std::string refusal;
  std::thread([&] {
    forbidden = give_up_privileges() && access(mouse.node().c_str(), R_OK) != 0;
    if (!forbidden) return;
    places = hid::find_hid(spacemouse_ids());
    listings = list_devices("");
    const auto port = hid::open_hid(places.at(0));
    if (!port) refusal = port.error().sentence;
  }).join();
  if (!forbidden) GTEST_SKIP() << "this system lets whoever runs the tests open a node of mode 0";
  ASSERT_EQ(places.size(), 1U) << "it is seen, though it may not be opened";
  EXPECT_FALSE(places[0].permitted);
  const auto listed = std::ranges::find(listings, "spacemouse", &DeviceListing::name);
  ASSERT_NE(listed, listings.end());
  EXPECT_FALSE(listed->present);
  for (const std::string& sentence : {listed->reason, refusal})
    for (const std::string& part : {mouse.node(), std::string("tools/run --udev")})
      EXPECT_NE(sentence.find(part), std::string::npos) << sentence;
}

TEST_F(Mock, WhatIsPluggedInIsListedAsThere) {
  MockHid mouse(machine, spacemouse()), pad(machine, dualsense(true, 0));
  for (const DeviceListing& device : list_devices("no window"))
    if (device.name == "spacemouse" || device.name == "dualsense")
      EXPECT_TRUE(device.present) << device.reason;
  EXPECT_EQ(best_device("").name, "spacemouse");
}

TEST_F(Mock, SpaceMouseMovesAndDualSenseVibratesBeside) {
  MockHid mouse(machine, spacemouse()), pad(machine, dualsense(false, 0x0224));
  DeviceDesc desc = MouseDevice::mouse_desc();
  desc.vibrotactile = {{{.name = "left", .kind = ChannelKind::rumble, .largest = 20, .lag = 0.04},
                        {.name = "right", .kind = ChannelKind::rumble, .largest = 20, .lag = 0.02}}};
  const DeviceOrder order{.desc = desc, .signal = VibrotactileSignal{.largest = 20}, .X_DH = Pose{}};
  const auto open = open_device("spacemouse+dualsense", order);
  ASSERT_TRUE(open) << open.error().sentence;
  ASSERT_NE(open->rate, nullptr);
  EXPECT_EQ(open->device->read().X_DH.p, Vec3::Zero());
  say_until(mouse, kRight, [&] { return open->device->read().X_DH.p.x() > 1e-3; });
  EXPECT_EQ(open->device->read().X_DH.p.y(), 0);
  DeviceCommand command;
  command.vibrotactile.level = {20, 10};
  open->device->write(command);
  wait_for([&] { return !pad.written().empty(); });
  EXPECT_EQ(pad.written().front()[4], 255) << "left";
  EXPECT_EQ(pad.written().front()[3], 128) << "right";
  EXPECT_TRUE(open->device->read().connected);
  pad.unplug();
  wait_for([&] { return !open->device->read().connected; });
}

// Seven numbers, low byte first, as the board of a Polhem says and hears them; its descriptor is a vendor's
// own.
Bytes board_report(const std::array<int, 7>& numbers) {
  Bytes report;
  for (const int number : numbers) {
    report.push_back(static_cast<std::uint8_t>(number & 255));
    report.push_back(static_cast<std::uint8_t>(number >> 8 & 255));
  }
  return report;
}

MockHidFacts polhem() {
  return {.id = {0x1234, 0x0006},
          .name = "mbed",
          .descriptor = {0x06, 0x00, 0xFF, 0x09, 0x01, 0xA1, 0x01, 0x75, 0x08, 0x95, 0x0E,
                         0x09, 0x01, 0x81, 0x02, 0x95, 0x0E, 0x09, 0x01, 0x91, 0x02, 0xC0}};
}

// Of content/devices/polhem.yaml, as far as its driver needs it.
DeviceDesc polhem_desc() {
  DeviceDesc desc;
  desc.kinematics = Kinematics::arms;
  desc.mechanism.q_DK = Quat(0.5, -0.5, -0.5, -0.5);
  desc.mechanism.arms = {
      {"arm",
       {{.name = "yaw", .axis_K = {0, 0, 1}, .max_torque = 1.936},
        {.name = "shoulder", .axis_K = {0, -1, 0}, .point_K = {0, 0, 0.058}, .home = -0.4393498},
        {.name = "elbow",
         .axis_K = {0, -1, 0},
         .point_K = {0, 0, 0.232},
         .home = 0.9585170,
         .through_parallelogram = true}},
       Vec3(0, 0, 0.099)}};
  return desc;
}

TEST_F(Mock, APolhemIsPushedWithAndLetGo) {
  MockHid board(machine, polhem());
  for (const DeviceListing& device : list_devices("no window"))
    if (device.name == "polhem") EXPECT_TRUE(device.present) << device.reason;
  EXPECT_EQ(best_device("").name, "polhem");

  // It answers what it hears, while it is plugged in.
  std::atomic<bool> on{true}, plugged{true}, asks{true};  // its button was pressed
  std::atomic<std::size_t> answered{0};
  std::atomic<int> yaw{100};
  std::thread firmware([&] {
    for (; on; std::this_thread::yield()) {
      const std::size_t heard = board.times_written();
      if (!plugged || heard == answered || !board.all_read()) continue;
      answered = heard;
      if (board.written().back()[7] == 1) asks = false;
      board.say(board_report({yaw, 0, -4000, 0, 0, 0, asks ? 1 : 0}));
    }
  });
  auto open = open_device("polhem", {.desc = polhem_desc(), .X_DH = Pose{}});
  ASSERT_TRUE(open) << open.error().sentence;
  const Vec3 at = open->device->read().X_DH.p;
  yaw = 1000;
  wait_for([&] { return (open->device->read().X_DH.p - at).norm() > 0.01; });
  EXPECT_TRUE(open->device->read().connected);

  DeviceCommand push;
  push.effort[0] = 1;
  const auto current = [](const Bytes& heard) {
    return static_cast<std::int16_t>(heard[1] + 256 * heard[2]);
  };
  wait_for([&] {
    open->device->write(push);
    const Bytes last = board.written().back();
    return last.size() == 15 && current(last) == -1033;
  });
  // Nobody renews it.
  wait_for([&] { return current(board.written().back()) == 0; });
  plugged = false;
  board.unplug();
  wait_for([&] { return !open->device->read().connected; });
  answered = board.times_written();
  asks = true;
  board.plug();
  plugged = true;
  wait_for([&] { return open->device->read().connected; });
  open->device.reset();
  EXPECT_EQ(current(board.written().back()), 0);
  on = false;
  firmware.join();
}

}  // namespace
}  // namespace fulcrum::test
