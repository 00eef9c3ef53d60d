#include "drivers/controller/controller_device.h"

#include <gtest/gtest.h>

#include "drivers/registry.h"
#include "haptics/math/rotation.h"

namespace fulcrum {
namespace {

constexpr double kHandTick = 1e-3;
const Pose kHandStart{turn_by(0.2, Vec3::UnitX()), Vec3(0.1, 0.2, 0.3)};
const Pose kHandAim{turn_by(0.5, Vec3::UnitY()), Vec3(0.15, 0.2, 0.25)};

DeviceDesc hand_channels() {
  DeviceDesc desc;
  desc.kinematics = Kinematics::none;
  desc.vibrotactile =
      VibrotactileDesc{{{.name = "left", .kind = ChannelKind::tone, .largest = 15, .lag = 0.02},
                        {.name = "right", .kind = ChannelKind::tone, .largest = 15, .lag = 0.02}}};
  return desc;
}

DeviceOrder hand_order() {
  return {.desc = hand_channels(),
          .signal = VibrotactileSignal{.carrier_Hz = 120, .largest = 10},
          .X_DH = kHandStart,
          .tick_s = kHandTick,
          .simulated = {},
          .replay = {}};
}

TEST(Controller, HandleIsWhereItBeganUntilAHandMovesIt) {
  ControllerDevice device(hand_channels(), std::make_shared<Controllers>(120), kHandStart, kHandTick);
  for (int i = 0; i < 100; ++i) {
    const DeviceSample sample = device.read();
    EXPECT_LT((sample.X_DH.p - kHandStart.p).norm(), 1e-12);
    EXPECT_TRUE(sample.connected);
  }
}

// Twice a first-order lag of 8 ms: after 16 ms 1 - 3 exp(-2) of a step is done, but for what a tick rounds.
TEST(Controller, HandleFollowsWithoutAStepInSpeed) {
  const auto controllers = std::make_shared<Controllers>(120);
  ControllerDevice device(hand_channels(), controllers, kHandStart, kHandTick);
  controllers->move(kHandAim);
  const double all = (kHandAim.p - kHandStart.p).norm();
  const Vec3 first = device.read().X_DH.p;
  EXPECT_LT((first - kHandStart.p).norm(), 0.02 * all);
  Pose X_DH;
  for (int i = 1; i < 16; ++i) X_DH = device.read().X_DH;
  EXPECT_NEAR((X_DH.p - kHandStart.p).norm() / all, 1 - 3 * std::exp(-2.0), 0.04);
  for (int i = 0; i < 300; ++i) X_DH = device.read().X_DH;
  EXPECT_LT((X_DH.p - kHandAim.p).norm(), 1e-9);
  EXPECT_LT(angle_between(X_DH.q, kHandAim.q), 1e-7);
}

// By itself, and beside another device: what the channels are told comes to the two hands.
TEST(Controller, ChannelsAreTheHands) {
  for (const char* name : {"controller", "mouse+controller"}) {
    Result<OpenDevice> opened = open_device(name, hand_order());
    ASSERT_TRUE(opened) << name;
    ASSERT_NE(opened->controllers, nullptr) << name;
    EXPECT_EQ(opened->controllers->carrier_Hz(), 120);
    EXPECT_EQ(opened->controllers->strengths(), (std::array<double, kHands>{0, 0}));
    DeviceCommand command;
    command.vibrotactile.level = {0, 5};
    for (int i = 0; i < 500; ++i) {
      opened->device->read();
      opened->device->write(command);
    }
    EXPECT_EQ(opened->controllers->strengths()[0], 0) << name;
    EXPECT_GT(opened->controllers->strengths()[1], 0.2) << name;
    command.vibrotactile = {.level = {}, .glide = 0.005, .stopping = true};
    for (int i = 0; i < 50; ++i) opened->device->write(command);
    EXPECT_EQ(opened->controllers->strengths()[1], 0) << name;
  }
}

TEST(Controller, IsThereOnlyForAHeadset) {
  const auto refused = refuse_device("controller", {"", true});
  ASSERT_TRUE(refused);
  EXPECT_NE(refused->sentence.find("--xr"), std::string::npos);
  EXPECT_FALSE(refuse_device("controller", {"There is no display.", true, true}));
  EXPECT_FALSE(refuse_device("simulated+controller", {"There is no display.", true, true}));
  EXPECT_TRUE(refuse_device("mouse", {"There is no display.", true, true}));
}

}  // namespace
}  // namespace fulcrum
