// A device's threads against a port that the test holds the other end of. Whatever is waited for is waited
// for until it is seen: no clock decides.

#include "drivers/hid/hid_link.h"

#include <gtest/gtest.h>

#include <atomic>
#include <deque>
#include <thread>
#include <vector>

#include "drivers/dualsense/dualsense_protocol.h"
#include "drivers/spacemouse/spacemouse_protocol.h"

namespace fulcrum::test {
namespace {

using Bytes = std::vector<std::uint8_t>;

// What is on the bus, whichever link is open.
struct Bus {
  std::mutex mutex;
  std::condition_variable more;
  bool plugged = true;
  bool takes = true;  // writes
  std::deque<Bytes> coming;
  std::vector<Bytes> written;
  std::vector<std::uint8_t> asked;  // feature reports

  void say(Bytes report) {
    const std::lock_guard lock(mutex);
    coming.push_back(std::move(report));
    more.notify_all();
  }
  void plug(bool in) {
    const std::lock_guard lock(mutex);
    plugged = in;
    coming.clear();
    more.notify_all();
  }
  std::vector<Bytes> all_written() {
    const std::lock_guard lock(mutex);
    return written;
  }
};

class BusPort final : public hid::HidPort {
public:
  explicit BusPort(Bus& bus) : bus_(bus) {}
  int read(std::span<std::uint8_t> report, int wait_ms) override {
    std::unique_lock lock(bus_.mutex);
    bus_.more.wait_for(lock, std::chrono::milliseconds(wait_ms),
                       [&] { return !bus_.plugged || !bus_.coming.empty(); });
    if (!bus_.plugged) return -1;
    if (bus_.coming.empty()) return 0;
    const Bytes next = bus_.coming.front();
    bus_.coming.pop_front();
    std::ranges::copy(next, report.begin());
    return static_cast<int>(next.size());
  }
  bool write(std::span<const std::uint8_t> report) override {
    const std::lock_guard lock(bus_.mutex);
    if (!bus_.plugged || !bus_.takes) return false;
    bus_.written.emplace_back(report.begin(), report.end());
    return true;
  }
  int read_feature(std::span<std::uint8_t> feature) override {
    const std::lock_guard lock(bus_.mutex);
    bus_.asked.push_back(feature[0]);
    return -1;
  }

private:
  Bus& bus_;
};

hid::HidOpened spacemouse_at(Bus& bus) {
  const std::lock_guard lock(bus.mutex);
  if (!bus.plugged) return {};
  return {std::make_unique<BusPort>(bus), std::make_unique<SpaceMouseProtocol>()};
}

hid::HidOpened dualsense_at(Bus& bus) {
  const std::lock_guard lock(bus.mutex);
  if (!bus.plugged) return {};
  return {std::make_unique<BusPort>(bus), std::make_unique<dualsense::DualSenseProtocol>(sony::Link::usb)};
}

void wait_for(auto seen) {
  while (!seen()) std::this_thread::yield();
}

const Bytes kRight{1, 0x5E, 0x01, 0, 0, 0, 0};  // 350
const Bytes kMiddle{1, 0, 0, 0, 0, 0, 0};

TEST(HidLink, TheNewestReportIsRead) {
  Bus bus;
  hid::HidLink link(spacemouse_at(bus), [&] { return spacemouse_at(bus); });
  EXPECT_TRUE(link.read().axes.rests());
  bus.say(kRight);
  wait_for([&] { return link.read().axes.way.x() == 1; });
  bus.say(kMiddle);
  wait_for([&] { return link.read().axes.rests(); });
  EXPECT_TRUE(link.read().connected);
}

// A cap that was pushed when its device fell silent would push the tool for ever.
TEST(HidLink, APushWithoutAWordIsLetGo) {
  Bus bus;
  hid::HidLink link(spacemouse_at(bus), [&] { return spacemouse_at(bus); });
  bus.say(kRight);
  wait_for([&] { return link.reports() == 1; });
  wait_for([&] { return link.read().axes.rests(); });
  EXPECT_TRUE(link.read().connected);
}

TEST(HidLink, APadThatStreamsGrowsOldWithoutAWord) {
  Bus bus;
  hid::HidLink link(
      dualsense_at(bus), [&] { return dualsense_at(bus); });
  wait_for([&] { return link.read().age > 0.1; });
  Bytes at_rest(64);
  at_rest[0] = 1;
  at_rest[8] = 8;
  std::fill(at_rest.begin() + 1, at_rest.begin() + 5, std::uint8_t{128});
  bus.say(at_rest);
  wait_for([&] { return link.reports() == 1 && link.read().age < 0.1; });
}

TEST(HidLink, WhatIsNoReportIsCountedAndPassedOver) {
  Bus bus;
  hid::HidLink link(spacemouse_at(bus), [&] { return spacemouse_at(bus); });
  bus.say({0x99, 1, 2, 3});
  bus.say({1});
  wait_for([&] { return link.refused() == 2; });
  EXPECT_EQ(link.reports(), 0U);
  EXPECT_TRUE(link.read().axes.rests());
}

TEST(HidLink, UnpluggedItSaysSoAndPluggedInAgainItGoesOn) {
  Bus bus;
  hid::HidLink link(spacemouse_at(bus), [&] { return spacemouse_at(bus); });
  for (int time = 0; time < 3; ++time) {
    bus.say(kRight);
    wait_for([&] { return link.read().axes.way.x() == 1; });
    bus.plug(false);
    wait_for([&] { return !link.read().connected; });
    bus.plug(true);
    wait_for([&] { return link.read().connected; });
    EXPECT_TRUE(link.read().axes.rests()) << "what was pushed before is not pushed now";
  }
}

TEST(HidLink, MotorsAreToldOnceAndRestAtTheEnd) {
  Bus bus;
  {
    hid::HidLink link(dualsense_at(bus), [&] { return dualsense_at(bus); });
    wait_for([&] {
      link.drive({1, 0});
      return !bus.all_written().empty();
    });
    EXPECT_EQ(bus.all_written().front()[4], 255);
    wait_for([&] {
      link.drive({0.5, 0});
      return bus.all_written().back()[4] == 128;
    });
  }
  EXPECT_EQ(bus.all_written().back()[4], 0);
  EXPECT_EQ(bus.asked, std::vector<std::uint8_t>{0x20}) << "its firmware's version";
}

TEST(HidLink, AReportThatWasNotTakenIsSentAgain) {
  Bus bus;
  hid::HidLink link(dualsense_at(bus), [&] { return dualsense_at(bus); });
  {
    const std::lock_guard lock(bus.mutex);
    bus.takes = false;
  }
  bus.say({0});  // the link goes on reading meanwhile
  wait_for([&] { return link.refused() == 1; });
  {
    const std::lock_guard lock(bus.mutex);
    bus.takes = true;
  }
  wait_for([&] {
    link.drive({1, 1});
    return !bus.all_written().empty() && bus.all_written().back()[4] == 255;
  });
}

TEST(HidLink, ItsEndDoesNotWaitForADeviceThatIsAway) {
  Bus bus;
  auto link = std::make_unique<hid::HidLink>(spacemouse_at(bus), [&] { return spacemouse_at(bus); });
  bus.plug(false);
  wait_for([&] { return !link->read().connected; });
  link.reset();
}

}  // namespace
}  // namespace fulcrum::test
