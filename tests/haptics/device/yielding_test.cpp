// What the model of a yielding hand promises: its reaction is exact in ticks, it turns towards the tool and
// not beyond, and without a cue it is the hand that does not yield.

#include "haptics/device/yielding.h"

#include <gtest/gtest.h>

#include <cmath>

#include "haptics/device/simulated_device.h"
#include "haptics/math/rotation.h"
#include "tests/haptics/tick_length.h"

namespace fulcrum::test {
namespace {

using Cues = DeviceCommand::Cues;

// A handle that is turned wrongly by `wrong` (3) rad and told of it, as a held tool would.
class Wrong {
public:
  Wrong(const YieldingDesc& desc, const Vec3& wrong, std::uint64_t seed = 1)
      : hand_(desc, kTick, seed), wrong_(quaternion_exp(wrong)) {}

  Vec3 left() const { return -rotation_vector(hand_.turn() * wrong_); }  // (3) rad, back to the tool
  void told(double vibration, double ghost) { hand_.advance({vibration, ghost, left()}); }
  void untold() { hand_.advance({}); }
  double turned() const { return rotation_vector(hand_.turn()).norm(); }

private:
  Yielding hand_;
  Quat wrong_;
};

TEST(Yielding, ReactionIsExactInTicks) {
  for (const double reaction : {0.0, 0.05, 0.25}) {
    Wrong hand({.reaction = reaction, .spread = 0}, {0.4, 0, 0});
    const auto ticks = std::lround(reaction / kTick);
    for (long i = 0; i < ticks; ++i) {
      hand.told(0.4, 0);
      EXPECT_EQ(hand.turned(), 0) << "tick " << i;
    }
    hand.told(0.4, 0);
    EXPECT_GT(hand.turned(), 0) << "reaction " << reaction;
  }
}

TEST(Yielding, GoesOnForAReactionAfterTheCueEnds) {
  Wrong hand({.reaction = 0.1, .spread = 0, .felt_error_rad = 0}, {0, 0.5, 0});
  for (int i = 0; i < 150; ++i) hand.told(0.4, 0);
  const double before = hand.turned();
  for (int i = 0; i < 100; ++i) hand.untold();
  EXPECT_NEAR(hand.turned() - before, 0.1, 1e-9) << "100 ticks at 1 rad/s";
  const double most = hand.turned();
  hand.untold();
  EXPECT_LT(hand.turned(), most);
}

TEST(Yielding, SpeedIsGainTimesTheCue) {
  const YieldingDesc desc{.reaction = 0, .gain = 2, .spread = 0, .full_vibration = 0.5, .felt_error_rad = 0};
  const auto speed = [&desc](double vibration, double ghost) {
    Wrong hand(desc, {0.9, 0, 0});
    for (int i = 0; i < 100; ++i) hand.told(vibration, ghost);
    return hand.turned() / (100 * kTick);
  };
  EXPECT_NEAR(speed(0.5, 0), 2, 1e-9);
  EXPECT_NEAR(speed(0.25, 0), 1, 1e-9);
  EXPECT_NEAR(speed(5, 0), 2, 1e-9) << "no more than a full cue";
  EXPECT_NEAR(speed(0.25, 1), 2, 1e-2) << "the stronger of the two, and a small error of the way";
  EXPECT_EQ(speed(0.9 * desc.least_vibration, 0), 0) << "too weak to be felt";
}

// However late it reacts and however it errs: each tick brings the tool nearer, and past it is nearer no
// more.
TEST(Yielding, NeverOvershoots) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Wrong hand({.reaction = 0.25, .gain = 3}, Vec3(0.1, -0.5, 0.3), seed);
    double before = hand.left().norm();
    for (int i = 0; i < 3000; ++i) {
      hand.told(0.4, seed % 2 == 0 ? 1 : 0);
      const double now = hand.left().norm();
      ASSERT_LE(now, before + 1e-12) << "seed " << seed << ", tick " << i;
      before = now;
    }
  }
}

TEST(Yielding, TheGhostShowsTheWayThatVibrationDoesNot) {
  const auto mean_error = [](double ghost) {
    double sum = 0;
    constexpr int seeds = 400;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      Wrong hand({.reaction = 0}, {0.5, 0, 0}, seed);
      const Vec3 before = hand.left();
      hand.told(0.4, ghost);
      const Vec3 turn = before - hand.left();
      // |error| of a normal error has the mean sigma sqrt(2 / pi).
      sum += std::acos(std::min(1.0, turn.normalized().dot(before.normalized())));
    }
    return sum / seeds / std::sqrt(2 / 3.14159265358979);
  };
  const YieldingDesc desc;
  EXPECT_NEAR(mean_error(0), desc.felt_error_rad, 0.1 * desc.felt_error_rad);
  EXPECT_NEAR(mean_error(1), desc.seen_error_rad, 0.1 * desc.seen_error_rad);
}

TEST(Yielding, GoesBackToWhatItMeant) {
  const YieldingDesc desc{.reaction = 0, .recovery = 0.5};
  Wrong hand(desc, {0, 0, 0.6});
  for (int i = 0; i < 300; ++i) hand.told(0.4, 1);
  const double turned = hand.turned();
  ASSERT_GT(turned, 0.2);
  for (int i = 0; i < 500; ++i) hand.untold();
  EXPECT_NEAR(hand.turned(), turned * std::exp(-1.0), 1e-9);
  for (int i = 0; i < 20000; ++i) hand.untold();
  EXPECT_EQ(hand.turned(), 0);
}

// ln(turned at once) is normal about ln(gain tick): its spread is the stated one.
TEST(Yielding, GainsSpreadAsStated) {
  double sum = 0, squares = 0;
  constexpr int seeds = 2000;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    Wrong hand({.reaction = 0, .gain = 1.5, .spread = 0.3, .felt_error_rad = 0}, {0.5, 0, 0}, seed);
    hand.told(0.4, 0);
    const double log_of_median = std::log(hand.turned() / (1.5 * kTick));
    sum += log_of_median / seeds;
    squares += log_of_median * log_of_median / seeds;
  }
  EXPECT_NEAR(sum, 0, 0.02);
  EXPECT_NEAR(std::sqrt(squares), 0.3, 0.02);
}

TEST(Yielding, TheSeedDecides) {
  const auto after = [](std::uint64_t seed) {
    Wrong hand({}, {0.4, 0.1, 0}, seed);
    for (int i = 0; i < 600; ++i) hand.told(0.3, 0);
    return hand.left();
  };
  EXPECT_EQ(after(5), after(5));
  EXPECT_NE(after(5), after(6));
}

SimulatedDevice device_with(const std::optional<YieldingDesc>& yields) {
  const Pose there{Quat(Eigen::AngleAxisd(0.5, Vec3::UnitY())), Vec3(0.02, 0, 0)};
  HandTask task{.path = HandPath({{Pose{}, 0, 0.1}, {there, 0.5, 1}}),
                .hand = {.yields = yields},
                .X_HT = Pose{},
                .mapping = {}};
  return {SimulatedDeviceDesc{}, std::move(task)};
}

TEST(YieldingDevice, WithoutACueIsTheHandThatDoesNotYieldBitForBit) {
  SimulatedDevice plain = device_with(std::nullopt), yielding = device_with(YieldingDesc{});
  for (int i = 0; i < 1500; ++i) {
    // A turn that is not told of is none.
    const DeviceCommand command{.F_H_D = {Vec3(0.1, 0, -0.2), Vec3::Zero()}, .cues = {0, 0, Vec3(0.3, 0, 0)}};
    plain.write(command);
    yielding.write(command);
    ASSERT_EQ(plain.X_DH().p, yielding.X_DH().p) << i;
    ASSERT_EQ(plain.X_DH().q.coeffs(), yielding.X_DH().q.coeffs()) << i;
  }
}

TEST(YieldingDevice, TurnsTheHandleAboutItselfTowardsTheTool) {
  SimulatedDevice plain = device_with(std::nullopt),
                  yielding = device_with(YieldingDesc{.seen_error_rad = 0});
  for (int i = 0; i < 1500; ++i) {
    const Vec3 back = -rotation_vector(yielding.X_DH().q);  // the tool is held unturned
    plain.write({});
    yielding.write({.F_H_D = {}, .cues = {0.4, 1, back}});
  }
  EXPECT_NEAR(rotation_vector(plain.X_DH().q).norm(), 0.5, 0.02);
  EXPECT_LT(rotation_vector(yielding.X_DH().q).norm(), 0.02);
  EXPECT_LT((plain.X_DH().p - yielding.X_DH().p).norm(), 1e-9) << "a turn about the handle does not move it";
}

}  // namespace
}  // namespace fulcrum::test
