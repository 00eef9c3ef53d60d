#include "drivers/controller/controller_device.h"

#include <gtest/gtest.h>

#include "drivers/registry.h"
#include "haptics/math/rotation.h"

namespace fulcrum {
namespace {

constexpr double kHandTick = 1e-3, kHandLag = 8e-3;  // s
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
  ControllerDevice device(hand_channels(), std::make_shared<Controllers>(120), kHandStart, kHandLag,
                          kHandTick);
  for (int i = 0; i < 100; ++i) {
    const DeviceSample sample = device.read();
    EXPECT_LT((sample.X_DH.p - kHandStart.p).norm(), 1e-12);
    EXPECT_TRUE(sample.connected);
  }
}

// Twice a first-order lag of 8 ms: after 16 ms 1 - 3 exp(-2) of a step is done, but for what a tick rounds.
TEST(Controller, HandleFollowsWithoutAStepInSpeed) {
  const auto controllers = std::make_shared<Controllers>(120);
  ControllerDevice device(hand_channels(), controllers, kHandStart, kHandLag, kHandTick);
  controllers->move({kHandAim});
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

// Its sample is as old as the hand is out of sight, in ticks and in what was lost of them.
TEST(Controller, AgesWhileNobodySeesTheHandThatHoldsIt) {
  const auto controllers = std::make_shared<Controllers>(120);
  ControllerDevice device(hand_channels(), controllers, kHandStart, kHandLag, kHandTick);
  device.miss(50);
  EXPECT_EQ(device.read().age, 0);
  controllers->move({kHandAim, false});
  for (int i = 1; i <= 20; ++i) EXPECT_NEAR(device.read().age, i * kHandTick, 1e-12);
  device.miss(5);
  EXPECT_NEAR(device.read().age, 26 * kHandTick, 1e-12);
  controllers->move({kHandAim, true});
  EXPECT_EQ(device.read().age, 0);
}

// Cameras that see a hand 30 times a second, and a runtime that foresees nothing: 0.3 m/s in steps of 9.9 mm.
// Behind two lags of T in a row the speed is each step times the sum of t/T^2 exp(-t/T) over those before,
// which lies between 0.71 and 1.17 of the mean with T = 16 ms. (With the 8 ms of a controller, 0.28 to 1.65.)
TEST(TrackedHand, StepsOfCamerasBecomeOneMotion) {
  Result<OpenDevice> opened = open_device("tracked_hand", hand_order());
  ASSERT_TRUE(opened);
  constexpr double kSpeed = 0.3;  // m/s
  Pose wanted = kHandStart, before = kHandStart;
  double slowest = kSpeed, fastest = kSpeed;
  for (int tick = 0; tick < 990; ++tick) {
    if (tick % 33 == 0) wanted.p.x() += 33 * kHandTick * kSpeed;
    opened->controllers->move({wanted});
    const Pose now = opened->device->read().X_DH;
    const double speed = (now.p - before.p).norm() / kHandTick;
    before = now;
    if (tick < 330) continue;
    slowest = std::min(slowest, speed);
    fastest = std::max(fastest, speed);
  }
  EXPECT_NEAR(slowest / kSpeed, 0.71, 0.03);
  EXPECT_NEAR(fastest / kSpeed, 1.17, 0.03);
}

TEST(TrackedHand, IsThereOnlyForAHeadsetAndVibratesByNothing) {
  EXPECT_TRUE(refuse_device("tracked_hand", {"", true}));
  EXPECT_FALSE(refuse_device("tracked_hand", {"There is no display.", true, true}));
  EXPECT_TRUE(tracks_hands("tracked_hand"));
  EXPECT_TRUE(tracks_hands("tracked_hand+audio"));
  EXPECT_FALSE(tracks_hands("controller"));
  EXPECT_TRUE(moves_as_seen("tracked_hand"));
  EXPECT_FALSE(read_device_name("mouse+tracked_hand"));
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
