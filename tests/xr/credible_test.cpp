// A runtime that says what cannot be true: of any bits, what passes is a place that a tool may be moved to.
//
// References: IEEE 754 bit patterns, all kinds of them; a quaternion's length from its definition.

#include "engine/xr/credible.h"

#include <gtest/gtest.h>

#include <bit>
#include <limits>
#include <random>

#include "engine/xr/hand_tracking.h"
#include "engine/xr/pose.h"
#include "haptics/math/rotation.h"

namespace fulcrum::xr {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN(),
                kEndless = std::numeric_limits<float>::infinity();
constexpr XrTime kPicture = 11'111'111;  // ns

const XrPosef kPlace{{0, 0.6F, 0, 0.8F}, {0.1F, 1.2F, -0.4F}};

TEST(Credible, APlaceIsTakenAsItIsSaid) {
  const std::optional<Pose> X = credible(kPlace);
  ASSERT_TRUE(X);
  EXPECT_LT((X->p - Vec3(0.1, 1.2, -0.4)).norm(), 1e-7);
  EXPECT_NEAR(X->q.y(), 0.6, 1e-7);
  EXPECT_NEAR(X->q.norm(), 1, 1e-12);
}

TEST(Credible, WhatIsNoPlaceIsNotTaken) {
  for (const float wrong : {kNaN, kEndless, -kEndless, 101.0F, -1e30F}) {
    XrPosef pose = kPlace;
    pose.position.z = wrong;
    EXPECT_FALSE(credible(pose)) << wrong;
    EXPECT_FALSE(credible(pose.position)) << wrong;
  }
  for (const XrQuaternionf& q :
       {XrQuaternionf{0, 0, 0, 0}, XrQuaternionf{0, 0, 0, 0.98F}, XrQuaternionf{0, 0, 0, 1.02F},
        XrQuaternionf{kNaN, 0, 0, 1}, XrQuaternionf{kEndless, 0, 0, 1}, XrQuaternionf{1e38F, 0, 0, 0}})
    EXPECT_FALSE(credible(XrPosef{q, {0, 0, 0}})) << q.x << ' ' << q.w;
}

TEST(Credible, AnEyeSeesAPartOfWhatIsBeforeIt) {
  EXPECT_TRUE(is_credible({-0.7F, 0.6F, 0.6F, -0.65F}));
  EXPECT_TRUE(is_credible({0.1F, 0.6F, -0.1F, -0.65F})) << "all of it to one side";
  for (const XrFovf& fov :
       {XrFovf{0, 0, 0, 0}, XrFovf{-0.7F, 0.6F, 0.3F, 0.3F}, XrFovf{0.6F, -0.7F, 0.6F, -0.65F},
        XrFovf{-0.7F, 0.6F, -0.6F, 0.65F}, XrFovf{-0.7F, kNaN, 0.6F, -0.65F},
        XrFovf{-kEndless, 0.6F, 0.6F, -0.65F}, XrFovf{-0.7F, 1.6F, 0.6F, -0.65F}})
    EXPECT_FALSE(is_credible(fov)) << fov.angleLeft << ' ' << fov.angleRight << ' ' << fov.angleUp << ' '
                                   << fov.angleDown;
}

TEST(Credible, WhateverBitsAHandIsMadeOfItIsOutOfSightOrAHand) {
  std::mt19937 random(20261128);
  const auto any_float = [&] {
    // As often such a number as a runtime gives, so that some hands pass.
    return random() % 8 != 0 ? static_cast<float>(random() % 2001) * 1e-3F - 1.0F
                             : std::bit_cast<float>(static_cast<std::uint32_t>(random()));
  };
  int hands = 0;
  for (int i = 0; i < 20000; ++i) {
    std::array<XrHandJointLocationEXT, XR_HAND_JOINT_COUNT_EXT> joints{};
    for (XrHandJointLocationEXT& joint : joints) {
      joint.locationFlags = random() % 16 == 0 ? random() : 0xfU;
      joint.pose.orientation = random() % 2 == 0
                                   ? kPlace.orientation
                                   : XrQuaternionf{any_float(), any_float(), any_float(), any_float()};
      joint.pose.position = {any_float(), any_float(), any_float()};
    }
    const XrVector3f& palm = joints[XR_HAND_JOINT_PALM_EXT].pose.position;
    for (const XrHandJointEXT tip :
         {XR_HAND_JOINT_THUMB_TIP_EXT, XR_HAND_JOINT_INDEX_TIP_EXT, XR_HAND_JOINT_LITTLE_TIP_EXT}) {
      XrVector3f& p = joints[tip].pose.position;
      if (random() % 8 != 0) p = {palm.x + 0.1F * p.x, palm.y + 0.1F * p.y, palm.z + 0.1F * p.z};
    }
    auto locations = structure<XrHandJointLocationsEXT>(XR_TYPE_HAND_JOINT_LOCATIONS_EXT);
    locations.isActive = random() % 16 != 0 ? XR_TRUE : XR_FALSE;
    locations.jointCount = static_cast<std::uint32_t>(joints.size());
    locations.jointLocations = joints.data();
    const std::optional<HandJoints> hand = joints_of(locations);
    if (!hand) continue;
    ++hands;
    ASSERT_TRUE(hand->X_LP.is_finite());
    ASSERT_NEAR(hand->X_LP.q.norm(), 1, 1e-12);
    for (const Vec3& p : {hand->X_LP.p, hand->p_LThumb, hand->p_LIndex, hand->p_LLittle}) {
      ASSERT_TRUE(p.allFinite());
      ASSERT_LE(p.cwiseAbs().maxCoeff(), kFarthest);
      ASSERT_LT((p - hand->X_LP.p).norm(), 0.31) << "a tip that is not the hand's";
    }
  }
  EXPECT_GT(hands, 100);
}

TEST(Sighting, AHandGoesAsHandsDo) {
  Sighting sighting;
  Pose X = *credible(kPlace);
  XrTime time = kPicture;
  EXPECT_TRUE(sighting.follow(X, time));
  // 7.5 m/s that cameras see 30 times a second, and a runtime shows 90 times.
  for (int i = 0; i < 90; ++i) {
    if (i % 3 == 2) X.p.x() += 0.25;
    EXPECT_TRUE(sighting.follow(X, time += kPicture)) << i;
  }
}

TEST(Sighting, WhatIsSeenInEachPictureLeapsWithinOne) {
  Sighting sighting;
  Pose X = *credible(kPlace);
  XrTime time = kPicture;
  for (int i = 0; i < 9; ++i) {
    X.p.x() += 0.08;  // 7.2 m/s
    EXPECT_TRUE(sighting.follow(X, time += kPicture)) << i;
  }
  X.p.x() += 0.1;  // 9 m/s
  EXPECT_FALSE(sighting.follow(X, time += kPicture));
}

TEST(Sighting, WhatLayStillLeapsWithinAMomentAllTheSame) {
  Sighting sighting;
  Pose X = *credible(kPlace);
  XrTime time = kPicture;
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(sighting.follow(X, time += kPicture));
  X.p.x() += 0.3;
  EXPECT_FALSE(sighting.follow(X, time += kPicture));
}

TEST(Sighting, WhatLeapsIsOutOfSightForOnePicture) {
  Sighting sighting;
  Pose X = *credible(kPlace);
  XrTime time = kPicture;
  sighting.follow(X, time);
  X.p.y() += 0.3;
  EXPECT_FALSE(sighting.follow(X, time += kPicture));
  EXPECT_TRUE(sighting.follow(X, time += kPicture));
  X.q = turn_by(1.5, Vec3::UnitX()) * X.q;  // the hand was taken for its own back
  EXPECT_FALSE(sighting.follow(X, time += kPicture));
  EXPECT_TRUE(sighting.follow(X, time += kPicture));
  // As far as that a hand does go while nobody sees it.
  EXPECT_FALSE(sighting.follow(std::nullopt, time += kPicture));
  X.p.y() -= 0.5;
  EXPECT_TRUE(sighting.follow(X, time += kPicture));
  X.p.y() -= 0.5;
  EXPECT_TRUE(sighting.follow(X, time += 10 * kPicture));
}

}  // namespace
}  // namespace fulcrum::xr
