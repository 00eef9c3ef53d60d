// A device's thread against a bus that the test holds the other end of. Whatever is waited for is waited for
// until it is seen; that something does not come is never concluded from time.

#include "drivers/force/force_device.h"

#include <gtest/gtest.h>

#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

namespace fulcrum::test {
namespace {

// What is on the bus, whoever has it open.
struct Cable {
  std::mutex mutex;
  std::condition_variable turned;
  bool plugged = true;
  bool silent = false;
  bool blocked = false;  // a turn does not end
  double x = 0;          // m, of the handle
  std::vector<DeviceCommand> told;
  int openings = 0, closings = 0;

  void set(auto change) {
    const std::lock_guard lock(mutex);
    change();
    turned.notify_all();
  }
  // In the turns after this one.
  void wait_for_told(auto seen) {
    std::unique_lock lock(mutex);
    told.clear();
    turned.wait(lock, [&] { return !told.empty() && seen(told.back()); });
  }
};

class CableBus final : public ForceBus {
public:
  explicit CableBus(Cable& cable) : cable_(cable) {
    const std::lock_guard lock(cable_.mutex);
    ++cable_.openings;
  }
  ~CableBus() override {
    cable_.set([&] { ++cable_.closings; });
  }
  Turn exchange(const DeviceCommand& command, DeviceSample& sample) override {
    std::unique_lock lock(cable_.mutex);
    cable_.turned.wait(lock, [&] { return !cable_.blocked; });
    cable_.told.push_back(command);
    cable_.turned.notify_all();
    if (!cable_.plugged) return Turn::lost;
    if (cable_.silent) return Turn::none;
    sample.X_DH.p.x() = cable_.x;
    sample.age = 2e-4;
    return Turn::fresh;
  }
  std::string trouble() const override { return "its cable is bent."; }

private:
  Cable& cable_;
};

std::unique_ptr<ForceBus> on(Cable& cable) {
  {
    const std::lock_guard lock(cable.mutex);
    if (!cable.plugged) return nullptr;
  }
  return std::make_unique<CableBus>(cable);
}

std::unique_ptr<ForceDevice> started(Cable& cable) {
  auto device = ForceDevice::start(DeviceDesc{}, on(cable), [&] { return on(cable); });
  EXPECT_TRUE(device) << (device ? "" : device.error().sentence);
  return device ? std::move(*device) : nullptr;
}

DeviceCommand pushing(double newtons) {
  DeviceCommand command;
  command.F_H_D.force = Vec3(0, newtons, 0);
  command.effort[2] = newtons;
  return command;
}

void until(auto seen) {
  while (!seen()) std::this_thread::yield();
}

TEST(ForceDevice, TheNewestSampleIsReadAndTheNewestCommandSent) {
  Cable cable;
  cable.x = 0.01;
  const auto device = started(cable);
  EXPECT_EQ(device->read().X_DH.p.x(), 0.01) << "from the first on";
  cable.set([&] { cable.x = 0.02; });
  until([&] { return device->read().X_DH.p.x() == 0.02; });
  EXPECT_GE(device->read().age, 2e-4);
  EXPECT_TRUE(device->read().connected);
  // What is renewed in time is sent as it is.
  std::atomic<bool> renews{true};
  std::thread hand([&] {
    while (renews) device->write(pushing(3));
  });
  cable.wait_for_told([](const DeviceCommand& c) { return c.F_H_D.force.y() == 3 && c.effort[2] == 3; });
  renews = false;
  hand.join();
}

// A haptic thread that stands still, or is gone, pushes nobody: the command that it left is let go.
TEST(ForceDevice, ACommandThatNobodyRenewsIsLetGo) {
  Cable cable;
  const auto device = started(cable);
  device->write(pushing(3));
  cable.wait_for_told([](const DeviceCommand& c) { return c.F_H_D.is_zero() && c.effort[2] == 0; });
}

TEST(ForceDevice, TheMotorsRestAtTheEnd) {
  Cable cable;
  auto device = started(cable);
  for (int n = 0; n < 100; ++n) device->write(pushing(3));
  device.reset();
  ASSERT_GE(cable.told.size(), 5u);
  for (auto last = cable.told.end() - 5; last != cable.told.end(); ++last) {
    EXPECT_TRUE(last->F_H_D.is_zero());
    EXPECT_EQ(last->effort[2], 0);
  }
}

TEST(ForceDevice, WhatSaysNothingGrowsOld) {
  Cable cable;
  const auto device = started(cable);
  cable.set([&] { cable.silent = true; });
  until([&] { return device->read().age > 0.02; });
  EXPECT_TRUE(device->read().connected);
  cable.set([&] { cable.silent = false; });
  until([&] { return device->read().age < 0.02; });
}

TEST(ForceDevice, ReadAndWriteDoNotWaitForABusThatHangs) {
  Cable cable;
  const auto device = started(cable);
  cable.set([&] { cable.blocked = true; });
  for (int n = 0; n < 1000; ++n) {
    device->read();
    device->write(pushing(1));
  }
  until([&] { return device->read().age > 0.02; });
  cable.set([&] { cable.blocked = false; });
  until([&] { return device->read().age < 0.02; });
}

TEST(ForceDevice, UnpluggedItIsLostAndPluggedInAgainItIsBack) {
  Cable cable;
  const auto device = started(cable);
  cable.set([&] { cable.plugged = false; });
  until([&] { return !device->read().connected; });
  cable.set([&] {
    cable.x = 0.05;
    cable.plugged = true;
  });
  until([&] { return device->read().connected; });
  EXPECT_EQ(device->read().X_DH.p.x(), 0.05);
  EXPECT_EQ(cable.openings, 2);
}

// What does not answer any more may still hear: the last that it is told is no push.
TEST(ForceDevice, WhatIsLostIsToldToRestThoughAHandPushesOn) {
  Cable cable;
  const auto device = started(cable);
  std::atomic<bool> renews{true};
  std::thread hand([&] {
    while (renews) device->write(pushing(3));
  });
  cable.wait_for_told([](const DeviceCommand& c) { return c.F_H_D.force.y() == 3; });
  cable.set([&] { cable.plugged = false; });
  {
    std::unique_lock lock(cable.mutex);
    cable.turned.wait(lock, [&] { return cable.closings == 1; });
    EXPECT_TRUE(cable.told.back().F_H_D.is_zero());
    EXPECT_EQ(cable.told.back().effort[2], 0);
  }
  renews = false;
  hand.join();
}

TEST(ForceDevice, OneThatSaysNothingFromTheStartIsRefusedWithItsReason) {
  Cable cable;
  cable.silent = true;
  const auto refused = ForceDevice::start(DeviceDesc{}, on(cable), [&] { return on(cable); });
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().sentence, "its cable is bent.");
  for (const DeviceCommand& told : cable.told) EXPECT_TRUE(told.F_H_D.is_zero());
}

}  // namespace
}  // namespace fulcrum::test
