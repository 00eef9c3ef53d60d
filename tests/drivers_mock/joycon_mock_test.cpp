// A pair of Joy-Cons by the real hidapi, on nodes that umockdev stands in for. Whatever is waited for is
// waited for until it is seen: no clock decides.

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <thread>

#include "drivers/registry.h"
#include "tests/drivers_mock/mock_devices.h"

namespace fulcrum::test {
namespace {

constexpr hid::HidId kLeftHalf{0x057e, 0x2006}, kRightHalf{0x057e, 0x2007}, kProController{0x057e, 0x2009};

MockHidFacts joycon(hid::HidId id) {
  return {.id = id,
          .bluetooth = true,
          .name = "Joy-Con",
          // A gamepad whose reports 0x21 and 0x30 come with 48 bytes and whose 0x01 and 0x10 go with as many.
          .descriptor = {0x05, 0x01, 0x09, 0x05, 0xA1, 0x01, 0x06, 0x01, 0xFF, 0x85, 0x21, 0x09, 0x21,
                         0x75, 0x08, 0x95, 0x30, 0x81, 0x02, 0x85, 0x30, 0x09, 0x30, 0x75, 0x08, 0x95,
                         0x30, 0x81, 0x02, 0x85, 0x01, 0x09, 0x01, 0x75, 0x08, 0x95, 0x30, 0x91, 0x02,
                         0x85, 0x10, 0x09, 0x10, 0x75, 0x08, 0x95, 0x09, 0x91, 0x02, 0xC0}};
}

// What is inside: it says nothing until it is told to say all, answers what it is asked, and vibrates only
// after it was told that it may.
class JoyConFirmware {
public:
  JoyConFirmware(MockMachine& machine, hid::HidId id) : hid(machine, joycon(id)), runs_([this] { run(); }) {}
  ~JoyConFirmware() {
    on_ = false;
    runs_.join();
  }

  void off() {
    const std::lock_guard lock(mutex_);
    plugged_ = false;
    hid.unplug();
  }
  void on() {
    const std::lock_guard lock(mutex_);
    says_all = may_vibrate = false;
    heard_ = hid.times_written();
    hid.plug();
    plugged_ = true;
  }
  // Of both actuators, as last told.
  Bytes actuators() const {
    const std::vector<Bytes> all = hid.written();
    const auto last =
        std::find_if(all.rbegin(), all.rend(), [](const Bytes& report) { return report[0] == 0x10; });
    return last == all.rend() ? Bytes{} : Bytes(last->begin() + 2, last->end());
  }

  MockHid hid;
  std::atomic<bool> says_all{false}, may_vibrate{false};
  std::atomic<std::uint8_t> left_x{0x80}, right_x{0x80};  // the upper eight bits
  std::atomic<int> lost{3};                               // so many questions go by unheard

private:
  Bytes state(std::uint8_t number) const {
    Bytes report(49);
    report[0] = number;
    report[6] = report[9] = 0x00;
    report[7] = left_x / 16, report[10] = right_x / 16;
    report[8] = report[11] = 0x80;
    return report;
  }
  void answer(const Bytes& question) {
    if (lost > 0) {
      --lost;
      return;
    }
    Bytes report = state(0x21);
    report[13] = 0x80;
    report[14] = question[10];
    if (question[10] == 0x03) says_all = question[11] == 0x30;
    if (question[10] == 0x48) may_vibrate = question[11] == 0x01;
    if (question[10] == 0x10) std::copy_n(question.begin() + 11, 5, report.begin() + 15);
    if (question[10] == 0x10) std::fill(report.begin() + 20, report.end(), std::uint8_t{0xFF});  // blank
    hid.say(report);
  }
  void run() {
    for (; on_; std::this_thread::yield()) {
      const std::lock_guard lock(mutex_);
      if (!plugged_) continue;
      for (; heard_ < hid.times_written(); ++heard_) {
        const Bytes report = hid.written()[heard_];
        if (report[0] == 0x01) answer(report);
      }
      if (says_all && hid.all_read()) hid.say(state(0x30));
    }
  }

  std::mutex mutex_;  // it says nothing while it is being plugged in
  bool plugged_ = true;
  std::size_t heard_ = 0;
  std::atomic<bool> on_{true};
  std::thread runs_;
};

DeviceOrder order_at(double carrier_Hz) {
  DeviceDesc desc = MouseDevice::mouse_desc();
  desc.vibrotactile = {{{.name = "left", .kind = ChannelKind::tone, .largest = 10},
                        {.name = "right", .kind = ChannelKind::tone, .largest = 10}}};
  return {
      .desc = desc, .signal = VibrotactileSignal{.carrier_Hz = carrier_Hz, .largest = 10}, .X_DH = Pose{}};
}

class JoyConMock : public testing::Test {
protected:
  void SetUp() override { ASSERT_TRUE(machine.stands_in()) << "begin it by umockdev-wrapper"; }
  MockMachine machine;
};

TEST_F(JoyConMock, APairMovesAndVibratesAtTheCarrier) {
  JoyConFirmware left(machine, kLeftHalf), right(machine, kRightHalf);
  const auto open = open_device("joycon", order_at(160));
  ASSERT_TRUE(open) << open.error().sentence;
  wait_for([&] { return left.may_vibrate && right.may_vibrate; });
  left.left_x = 0xFF;
  wait_for([&] { return open->device->read().X_DH.p.x() > 1e-3; });
  EXPECT_TRUE(open->device->read().connected);
  left.left_x = 0x80;
  right.right_x = 0x00;
  wait_for([&] { return open->device->read().X_DH.q.y() < -1e-3; });

  DeviceCommand command;
  command.vibrotactile.level = {10, 5.01433};
  const auto told = [&](const Bytes& actuators) {
    return [&, actuators] {
      open->device->read();
      open->device->write(command);
      return left.actuators() == actuators && right.actuators() == actuators;
    };
  };
  // 160 Hz: the whole left, row 0x88 of the published table right.
  wait_for(told({0x00, 0x01, 0x40, 0x72, 0x00, 0x01, 0x40, 0x62}));
  command.vibrotactile.level = {};
  wait_for(told({0x00, 0x01, 0x40, 0x40, 0x00, 0x01, 0x40, 0x40}));
}

TEST_F(JoyConMock, UnpluggedItIsAskedAnewAndRestsAtTheEnd) {
  JoyConFirmware left(machine, kLeftHalf), right(machine, kRightHalf);
  auto open = open_device("joycon", order_at(320));
  ASSERT_TRUE(open) << open.error().sentence;
  DeviceCommand command;
  command.vibrotactile.level = {10, 10};
  const Bytes both{0x00, 0xC9, 0x40, 0x40, 0x00, 0xC9, 0x40, 0x40};
  const auto vibrate = [&] {
    open->device->write(command);
    return left.actuators() == both && right.actuators() == both;
  };
  wait_for(vibrate);
  right.off();
  wait_for([&] { return !open->device->read().connected; });
  right.on();
  wait_for([&] { return open->device->read().connected && right.says_all && right.may_vibrate; });
  wait_for(vibrate);
  open->device.reset();
  const Bytes rests{0x00, 0x01, 0x40, 0x40, 0x00, 0x01, 0x40, 0x40};
  EXPECT_EQ(left.actuators(), rests);
  EXPECT_EQ(right.actuators(), rests);
}

TEST_F(JoyConMock, OneHalfIsNoPair) {
  const auto reason = [] {
    const std::vector<DeviceListing> devices = list_devices("");
    return std::ranges::find(devices, "joycon", &DeviceListing::name)->reason;
  };
  EXPECT_NE(reason().find("left one"), std::string::npos) << reason();
  MockHid left(machine, joycon(kLeftHalf));
  EXPECT_NE(reason().find("right one"), std::string::npos) << reason();
  EXPECT_FALSE(open_device("joycon", order_at(160)));
  MockHid right(machine, joycon(kRightHalf));
  EXPECT_EQ(reason(), "");
  EXPECT_EQ(best_device("").name, "joycon");
}

TEST_F(JoyConMock, AProControllerIsBothHalvesAtOneNode) {
  JoyConFirmware pro(machine, kProController);
  const auto open = open_device("switch_pro", order_at(160));
  ASSERT_TRUE(open) << open.error().sentence;
  pro.left_x = 0xFF, pro.right_x = 0x00;
  wait_for([&] {
    const DeviceSample sample = open->device->read();
    return sample.X_DH.p.x() > 1e-3 && sample.X_DH.q.y() < -1e-3;
  });
  DeviceCommand command;
  command.vibrotactile.level = {0, 10};
  wait_for([&] {
    open->device->write(command);
    return pro.actuators() == Bytes{0x00, 0x01, 0x40, 0x40, 0x00, 0x01, 0x40, 0x72};
  });
}

}  // namespace
}  // namespace fulcrum::test
