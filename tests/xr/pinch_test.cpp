// A hand without a controller: what it holds goes with its palm, and fingers that come and go at the limit
// neither take nor drop anything.

#include "engine/xr/pinch.h"

#include <gtest/gtest.h>

#include "haptics/math/rotation.h"

namespace fulcrum::xr {
namespace {

const Pose kPalm{turn_by(0.4, Vec3(1, 2, -1).normalized()), Vec3(0.1, 1.2, -0.3)};
const Vec3 kThumb_P(-0.02, -0.03, -0.08);

// apart: m, the tips of thumb and index finger.
HandJoints hand_at(const Pose& X_LP, double apart, double little_apart = 0.08) {
  return {X_LP, X_LP * kThumb_P, X_LP * (kThumb_P + apart * Vec3::UnitY()).eval(),
          X_LP * (kThumb_P + little_apart * Vec3::UnitX()).eval()};
}

TEST(Pinch, TakesBelowOneLimitAndLetsGoBeyondAnother) {
  Pinch pinch;
  EXPECT_FALSE(pinch.follow(hand_at(kPalm, kTogether + 1e-6)).holds);
  EXPECT_TRUE(pinch.follow(hand_at(kPalm, kTogether - 1e-6)).holds);
  // What cameras are wrong by opens and closes nothing.
  for (int i = 0; i < 100; ++i)
    EXPECT_TRUE(pinch.follow(hand_at(kPalm, kTogether + (i % 2) * (kApart - kTogether - 1e-6))).holds) << i;
  EXPECT_FALSE(pinch.follow(hand_at(kPalm, kApart + 1e-6)).holds);
  for (int i = 0; i < 100; ++i)
    EXPECT_FALSE(pinch.follow(hand_at(kPalm, kApart - (i % 2) * (kApart - kTogether - 1e-6))).holds) << i;
}

TEST(Pinch, HoldsWhatIsBetweenTheTips) {
  Pinch pinch;
  pinch.follow(hand_at(kPalm, 0.05));
  const Hand hand = pinch.follow(hand_at(kPalm, 0.01));
  ASSERT_TRUE(hand.X_LG);
  EXPECT_LT((hand.X_LG->p - kPalm * (kThumb_P + 0.005 * Vec3::UnitY()).eval()).norm(), 1e-12);
  EXPECT_LT(angle_between(hand.X_LG->q, kPalm.q), 1e-7);
}

// The palm carries it: a turn about what is held leaves that where it is, whatever the fingers do meanwhile.
TEST(Pinch, WhatIsHeldGoesWithThePalm) {
  Pinch pinch;
  pinch.follow(hand_at(kPalm, 0.05));
  const Pose held = *pinch.follow(hand_at(kPalm, 0.015)).X_LG;
  for (const double apart : {0.002, 0.015, 0.034}) {
    const Hand still = pinch.follow(hand_at(kPalm, apart));
    EXPECT_LT((still.X_LG->p - held.p).norm(), 1e-12) << apart;
  }
  const Quat turn = turn_by(0.6, Vec3::UnitZ());
  const Pose turned{turn * kPalm.q, held.p + turn * (kPalm.p - held.p)};
  const Hand after = pinch.follow(hand_at(turned, 0.01));
  EXPECT_LT((after.X_LG->p - held.p).norm(), 1e-12);
  EXPECT_NEAR(angle_between(after.X_LG->q, held.q), 0.6, 1e-9);
}

TEST(Pinch, OutOfSightItDoesWhatItDid) {
  Pinch pinch;
  pinch.follow(hand_at(kPalm, 0.05));
  const Pose held = *pinch.follow(hand_at(kPalm, 0.01)).X_LG;
  const Hand gone = pinch.follow(std::nullopt);
  EXPECT_FALSE(gone.X_LG);
  EXPECT_FALSE(gone.is_known);
  EXPECT_TRUE(gone.holds) << "who never let go has not taken it anew, either";
  const Hand back = pinch.follow(hand_at(kPalm, 0.03));
  EXPECT_TRUE(back.holds);
  EXPECT_LT((back.X_LG->p - held.p).norm(), 1e-12);
  EXPECT_FALSE(pinch.follow(hand_at(kPalm, 0.05)).holds);
}

TEST(Pinch, AFistThatComesIntoSightHoldsNothingUntilItHasOpened) {
  Pinch pinch;
  for (int time = 0; time < 2; ++time) {
    EXPECT_FALSE(pinch.follow(hand_at(kPalm, 0.01)).holds);
    EXPECT_FALSE(pinch.follow(hand_at(kPalm, kApart - 1e-6)).holds);
    const Hand fist = pinch.follow(hand_at(kPalm, 0.01, 0.01));
    EXPECT_TRUE(fist.is_known);
    EXPECT_FALSE(fist.holds);
    EXPECT_FALSE(fist.stops);
    EXPECT_FALSE(pinch.follow(hand_at(kPalm, kApart + 1e-6)).holds);
    EXPECT_TRUE(pinch.follow(hand_at(kPalm, 0.01)).holds);
    EXPECT_FALSE(pinch.follow(hand_at(kPalm, 0.05)).holds);
    pinch.follow(std::nullopt);
  }
}

TEST(Pinch, ThumbAndLittleFingerStopUnlessSomethingIsHeld) {
  Pinch pinch;
  EXPECT_FALSE(pinch.follow(hand_at(kPalm, 0.06, kTogether + 1e-6)).stops);
  EXPECT_TRUE(pinch.follow(hand_at(kPalm, 0.06, 0.01)).stops);
  EXPECT_TRUE(pinch.follow(hand_at(kPalm, 0.06, kApart - 1e-6)).stops);
  EXPECT_FALSE(pinch.follow(hand_at(kPalm, 0.06, kApart + 1e-6)).stops);
  const Hand fist = pinch.follow(hand_at(kPalm, 0.01, 0.01));
  EXPECT_TRUE(fist.holds);
  EXPECT_FALSE(fist.stops);
}

}  // namespace
}  // namespace fulcrum::xr
