// A Falcon that runs, from its first packet to its last, on a model of the device that knows nothing of the
// driver.

#include "drivers/falcon/falcon_bus.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "drivers/force/force_device.h"
#include "tests/drivers/falcon_cable.h"

namespace fulcrum::test {
namespace {

using Fault = FalconModel::Fault;

DeviceCommand pushed_by(const Vec3& force) {
  DeviceCommand command;
  command.F_H_D.force = force;
  return command;
}

// Its firmware runs; the bus has found that out.
struct OnFalcon {
  FalconModel model{firmware_of(10), true};
  FalconCable* port;
  falcon::FalconBus bus;
  DeviceSample sample;

  OnFalcon() : OnFalcon(std::make_unique<FalconCable>(model)) {}
  ForceBus::Turn turn(const Vec3& force = Vec3::Zero()) { return bus.exchange(pushed_by(force), sample); }
  // At the beginning nothing is known of where the grip is; a turn later it is.
  void make_ready() {
    while (bus.starts()) turn();
    ASSERT_EQ(turn(), ForceBus::Turn::none);
    ASSERT_TRUE(model.home());
    ASSERT_EQ(turn(), ForceBus::Turn::fresh);
  }

private:
  explicit OnFalcon(std::unique_ptr<FalconCable> p)
      : port(p.get()), bus(std::move(p), [] { return brings_none(); }) {}
};

constexpr std::array<int, 3> kRest{};

TEST(Falcon, UntilItIsHomedItIsNotPushedWith) {
  OnFalcon falcon;
  while (falcon.bus.starts()) EXPECT_EQ(falcon.turn({1, 2, 3}), ForceBus::Turn::none);
  for (int n = 0; n < 50; ++n) {
    EXPECT_EQ(falcon.turn({1, 2, 3}), ForceBus::Turn::none);
    EXPECT_EQ(falcon.model.motors(), kRest);
    EXPECT_NE(falcon.model.lights() & falcon::kHoming, 0u);
  }
  EXPECT_NE(falcon.bus.trouble().find("pull the grip out"), std::string::npos) << falcon.bus.trouble();
  ASSERT_TRUE(falcon.model.home());
  EXPECT_EQ(falcon.turn({1, 2, 3}), ForceBus::Turn::fresh);
  EXPECT_EQ(falcon.model.motors(), kRest) << "it was not known yet";
  EXPECT_EQ(falcon.turn({1, 2, 3}), ForceBus::Turn::fresh);
  EXPECT_NE(falcon.model.motors(), kRest);
  EXPECT_EQ(falcon.model.lights(), falcon::kGreen);
  EXPECT_EQ(falcon.bus.trouble(), "");
}

// The force that the model's motors make on its grip is the one that was asked for, and nothing turns it
// round.
TEST(Falcon, ThePlaceIsReadAndTheForceIsFelt) {
  OnFalcon falcon;
  falcon.make_ready();
  SplitMix random(3);
  for (unsigned n = 0; n < 200; ++n) {
    const Vec3 place =
        0.07 * (Vec3(random.uniform(), random.uniform(), random.uniform()) - Vec3::Constant(0.5));
    const Vec3 force = 4 * (Vec3(random.uniform(), random.uniform(), random.uniform()) - Vec3::Constant(0.5));
    falcon.model.hold(place);
    falcon.model.press(n % 16);
    falcon.turn();
    ASSERT_EQ(falcon.turn(force), ForceBus::Turn::fresh);
    EXPECT_LT((falcon.sample.X_DH.p - place).norm(), 6e-5) << "a count";
    EXPECT_EQ(falcon.sample.X_DH.q.coeffs(), Quat::Identity().coeffs());
    EXPECT_EQ(falcon.sample.buttons, n % 16);
    EXPECT_LT((falcon.model.force_D() - force).norm(), 0.02) << force.transpose();
  }
}

TEST(Falcon, WhoDoesNotAnswerIsNotPushed) {
  OnFalcon falcon;
  falcon.make_ready();
  EXPECT_EQ(falcon.turn({0, 0, 3}), ForceBus::Turn::fresh);
  EXPECT_GT(falcon.model.force_D().z(), 2.9);
  falcon.model.have(Fault::silent);
  EXPECT_EQ(falcon.turn({0, 0, 3}), ForceBus::Turn::none);
  for (int n = 0; n < 5; ++n) {
    EXPECT_EQ(falcon.turn({0, 0, 3}), ForceBus::Turn::none);
    EXPECT_EQ(falcon.model.motors(), kRest);
  }
  falcon.model.have(Fault::none);
  EXPECT_EQ(falcon.turn({0, 0, 3}), ForceBus::Turn::fresh);
  EXPECT_EQ(falcon.model.motors(), kRest);
  EXPECT_EQ(falcon.turn({0, 0, 3}), ForceBus::Turn::fresh);
  EXPECT_GT(falcon.model.force_D().z(), 2.9);
}

TEST(Falcon, GarbageIsNoAnswer) {
  for (const auto fault : {Fault::garbles, Fault::impossible}) {
    OnFalcon falcon;
    falcon.make_ready();
    const Vec3 before = falcon.sample.X_DH.p;
    falcon.model.have(fault);
    falcon.model.hold({0.03, 0, 0});
    EXPECT_EQ(falcon.turn({0, 0, 3}), ForceBus::Turn::none);
    for (int n = 0; n < 5; ++n) {
      EXPECT_EQ(falcon.turn({0, 0, 3}), ForceBus::Turn::none);
      EXPECT_EQ(falcon.model.motors(), kRest);
    }
    EXPECT_EQ(falcon.sample.X_DH.p, before);
    EXPECT_EQ(falcon.bus.trouble().find("none of its kind") != std::string::npos, fault == Fault::impossible);
  }
}

// An answer that comes a turn late is thrown away, and the packet after it has no force.
TEST(Falcon, ALateAnswerIsNotTaken) {
  OnFalcon falcon;
  falcon.make_ready();
  falcon.port->late = 1;
  falcon.model.hold({0.02, 0, 0});
  EXPECT_EQ(falcon.turn({0, 0, 3}), ForceBus::Turn::none);
  falcon.model.hold({0.03, 0, 0});
  falcon.port->late = 0;
  EXPECT_EQ(falcon.turn({0, 0, 3}), ForceBus::Turn::fresh);
  EXPECT_EQ(falcon.model.motors(), kRest);
  EXPECT_NEAR(falcon.sample.X_DH.p.x(), 0.03, 6e-5) << "the newest";
}

// An answer that comes after the next packet has gone is one to the packet before it.
TEST(Falcon, ALateAnswerIsAsOldAsItsQuestion) {
  OnFalcon falcon;
  falcon.make_ready();
  falcon.port->late = 1;
  const AgeClock::time_point before = AgeClock::now();
  EXPECT_EQ(falcon.turn(), ForceBus::Turn::none);
  std::this_thread::sleep_for(std::chrono::milliseconds(30));
  EXPECT_EQ(falcon.turn(), ForceBus::Turn::fresh);
  EXPECT_GE(falcon.sample.age, 0.03);
  EXPECT_LE(falcon.sample.age, std::chrono::duration<double>(AgeClock::now() - before).count());
}

// One that was lost does not make all that come after it look older than they are.
TEST(Falcon, AnAnswerThatIsLostAgesOneSampleAlone) {
  OnFalcon falcon;
  falcon.make_ready();
  falcon.model.have(Fault::garbles);
  EXPECT_EQ(falcon.turn(), ForceBus::Turn::none);
  falcon.model.have(Fault::none);
  std::this_thread::sleep_for(std::chrono::milliseconds(30));
  EXPECT_EQ(falcon.turn(), ForceBus::Turn::fresh);
  EXPECT_GE(falcon.sample.age, 0.03) << "it may be the answer to the first";
  std::this_thread::sleep_for(std::chrono::milliseconds(30));
  const AgeClock::time_point before = AgeClock::now();
  EXPECT_EQ(falcon.turn(), ForceBus::Turn::fresh);
  EXPECT_LE(falcon.sample.age, std::chrono::duration<double>(AgeClock::now() - before).count());
}

TEST(Falcon, OneThatLosesItsPlaceIsLetGo) {
  OnFalcon falcon;
  falcon.make_ready();
  EXPECT_EQ(falcon.turn({0, 0, 3}), ForceBus::Turn::fresh);
  falcon.model.lose_home();
  EXPECT_EQ(falcon.turn({0, 0, 3}), ForceBus::Turn::none);
  EXPECT_EQ(falcon.turn({0, 0, 3}), ForceBus::Turn::none);
  EXPECT_EQ(falcon.model.motors(), kRest);
  EXPECT_NE(falcon.bus.trouble().find("pull the grip out"), std::string::npos);
}

TEST(Falcon, WhatCannotBeToldIsNoTurnAndUnpluggedItIsLost) {
  OnFalcon falcon;
  falcon.make_ready();
  falcon.port->takes = false;
  EXPECT_EQ(falcon.turn({0, 0, 3}), ForceBus::Turn::none);
  falcon.model.out(falcon::encode({}, falcon::kGreen));
  EXPECT_EQ(falcon.turn({0, 0, 3}), ForceBus::Turn::none) << "the answer is to another packet";
  falcon.port->takes = true;
  EXPECT_EQ(falcon.turn({0, 0, 3}), ForceBus::Turn::fresh);
  falcon.port->plugged = false;
  EXPECT_EQ(falcon.turn({0, 0, 3}), ForceBus::Turn::lost);
}

// From a cold start to rest by the device's own thread. It is homed while it is waited for.
TEST(Falcon, ADeviceIsStartedPushesAndRests) {
  const FalconModel::Bytes firmware = firmware_of(20000);
  FalconModel model(firmware);
  std::atomic<bool> ends{false};
  std::thread hand([&] {
    while (!ends && !model.home()) std::this_thread::yield();
  });
  auto bus = std::make_unique<falcon::FalconBus>(std::make_unique<FalconCable>(model), brings(firmware));
  auto device = ForceDevice::start(DeviceDesc{}, std::move(bus), [] { return nullptr; });
  ends = true;
  hand.join();
  ASSERT_TRUE(device) << device.error().sentence;
  model.hold({0, 0.02, 0});
  while ((*device)->read().X_DH.p.y() < 0.0199) std::this_thread::yield();
  while (model.force_D().y() < 1.9) (*device)->write(pushed_by({0, 2, 0}));
  while (model.motors() != kRest) std::this_thread::yield();  // nobody renews it
  while (model.force_D().y() < 1.9) (*device)->write(pushed_by({0, 2, 0}));
  device->reset();
  EXPECT_EQ(model.motors(), kRest);
}

TEST(Falcon, WhoWillNotStartIsRefusedWithItsReason) {
  FalconModel model(firmware_of(10));
  auto bus = std::make_unique<falcon::FalconBus>(std::make_unique<FalconCable>(model), &brings_none);
  const auto refused = ForceDevice::start(DeviceDesc{}, std::move(bus), [] { return nullptr; });
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().sentence, "there is no firmware.");
}

}  // namespace
}  // namespace fulcrum::test
