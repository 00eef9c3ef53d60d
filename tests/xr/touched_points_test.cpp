// Touches as a person makes them: still, shaking, out of sight, too near each other.

#include "engine/headset/touched_points.h"

#include <gtest/gtest.h>

#include "haptics/math/rotation.h"

namespace fulcrum::headset {
namespace {

constexpr double kFrame = 1.0 / 90;  // s

// Whoever has a controller in the right hand and the handle in the left, and knows where the base stands.
class Toucher {
public:
  explicit Toucher(double limit = 0.01) : points(limit) {}

  // From a release on, the controller `off` the handle; shaking: m, of each picture against the one before.
  void touch(const Vec3& p_D, const Vec3& off = Vec3::Zero(), double shaking = 0) {
    for (int i = 0; i < 40; ++i) {
      const Vec3 tip_L = X_LD * p_D + off + (i % 2 == 0 ? shaking : 0) * Vec3::UnitX();
      show(i > 2, false, tip_L, p_D);
    }
    show(false, false, X_LD * p_D, p_D);
  }
  void press_menu() {
    show(false, true, Vec3::Zero(), Vec3::Zero());
    show(false, false, Vec3::Zero(), Vec3::Zero());
  }
  void show(bool holds, bool stops, const std::optional<Vec3>& tip_L, const std::optional<Vec3>& p_DH) {
    TouchMoment moment{time_, {}, p_DH};
    moment.hands[1] = {std::nullopt, tip_L, holds, stops};
    moment.hands[1].is_known = !sleeps;
    points.note(moment);
    time_ += kFrame;
  }
  bool says(const char* what) const { return points.text().find(what) != std::string::npos; }

  Pose X_LD{turn_by(0.7, Vec3(0.1, 1, 0.2).normalized()), Vec3(0.3, 0.8, -0.4)};
  TouchedPoints points;
  bool sleeps = false;  // the controller

private:
  double time_ = 100;
};

const Vec3 kPlaces[] = {{-0.06, -0.02, 0.02}, {0.07, 0, 0}, {0, 0.05, -0.04}, {0.02, -0.03, 0.06}};

TEST(TouchedPoints, WhatNobodySeesIsNoTouch) {
  Toucher person;
  for (int i = 0; i < 10; ++i) person.show(i > 2, false, person.X_LD * kPlaces[0], kPlaces[0]);
  person.points.look_away();
  for (int i = 0; i < 60; ++i) person.show(true, false, person.X_LD * kPlaces[0], kPlaces[0]);
  EXPECT_TRUE(person.says("Point 1 of 3"))
      << "a squeeze that goes on takes nothing: " << person.points.text();
  person.touch(kPlaces[0]);
  EXPECT_TRUE(person.says("Point 2 of 3")) << person.points.text();
}

TEST(TouchedPoints, ThreeAndMoreFindTheBase) {
  Toucher person;
  EXPECT_TRUE(person.says("Point 1 of 3"));
  for (int i = 0; i < 3; ++i) {
    EXPECT_FALSE(person.points.fit());
    person.touch(kPlaces[i]);
  }
  ASSERT_TRUE(person.points.fit()) << person.points.text();
  EXPECT_TRUE(person.says("3 points, residual 0 mm RMS (0, 0, 0 mm)")) << person.points.text();
  person.touch(kPlaces[3]);
  EXPECT_EQ(person.points.fit()->residuals.size(), 4U);
  EXPECT_FALSE(person.points.is_taken());
  person.press_menu();
  EXPECT_TRUE(person.points.is_taken());
  const Pose off = person.points.fit()->X_LD.inverse() * person.X_LD;
  EXPECT_LT(off.p.norm() + angle_of(off.q), 1e-7);
}

TEST(TouchedPoints, AFarPlaceIsToldInPlainDigits) {
  Toucher person;
  for (int i = 0; i < 3; ++i) person.touch(kPlaces[i], i == 0 ? Vec3(99, 0, 0) : Vec3(0, 0, 0));
  ASSERT_TRUE(person.points.fit()) << person.points.text();
  ASSERT_GT(person.points.fit()->rms, 10);
  EXPECT_FALSE(person.says("e+")) << person.points.text();
}

TEST(TouchedPoints, WhatIsNoTouchIsSaidAndNotTaken) {
  Toucher person;
  person.touch(kPlaces[0], Vec3::Zero(), 0.01);
  EXPECT_TRUE(person.says("The controller moved by 5")) << person.points.text();
  EXPECT_TRUE(person.says("Point 1 of 3"));
  person.show(true, false, std::nullopt, kPlaces[0]);
  EXPECT_TRUE(person.says("The headset did not see the controller")) << person.points.text();
  person.show(false, false, std::nullopt, kPlaces[0]);
  person.show(true, false, Vec3::Zero(), std::nullopt);
  EXPECT_TRUE(person.says("The device does not say where its handle is")) << person.points.text();
  person.touch(kPlaces[0]);
  EXPECT_TRUE(person.says("Point 2 of 3")) << person.points.text();
  person.touch(kPlaces[0] + Vec3(0.01, 0, 0));
  EXPECT_TRUE(person.says("That is 10 mm from another point")) << person.points.text();
  person.touch(kPlaces[1]);
  person.press_menu();
  EXPECT_TRUE(person.says("Three points are needed at least")) << person.points.text();
  person.touch(2 * kPlaces[1] - kPlaces[0]);
  EXPECT_TRUE(person.says("The points lie nearly in a line")) << person.points.text();
  EXPECT_FALSE(person.points.fit());
  person.touch(kPlaces[2]);
  EXPECT_TRUE(person.points.fit()) << person.points.text();
}

// A squeeze that went on from before says nothing: another one has to begin.
TEST(TouchedPoints, ASqueezeThatGoesOnFromBeforeIsNone) {
  Toucher person;
  for (int i = 0; i < 60; ++i) person.show(true, true, Vec3::Zero(), kPlaces[0]);
  EXPECT_EQ(person.points.text().find("The force is off until"), 0U) << person.points.text();
  EXPECT_TRUE(person.says("Point 1 of 3"));
}

// Put down, or gripped, as it wakes: neither a squeeze nor a button of then is meant.
TEST(TouchedPoints, WhatIsPressedAsAControllerWakesIsNone) {
  Toucher person;
  for (const Vec3& place : kPlaces) person.touch(place);
  person.sleeps = true;
  person.show(false, false, std::nullopt, kPlaces[0]);
  person.sleeps = false;
  for (int i = 0; i < 60; ++i) person.show(true, true, Vec3(0.5, 0, 0), Vec3(0.2, 0.2, 0.2));
  EXPECT_FALSE(person.points.is_taken());
  ASSERT_TRUE(person.points.fit());
  EXPECT_EQ(person.points.fit()->residuals.size(), 4U) << person.points.text();
  person.show(false, false, Vec3::Zero(), kPlaces[0]);
  person.press_menu();
  EXPECT_TRUE(person.points.is_taken()) << "the next press is meant";
}

TEST(TouchedPoints, ALargeResidualIsKeptOnlyByWhoAsksForIt) {
  for (const double limit : {0.01, 0.05}) {
    Toucher person(limit);
    for (int i = 0; i < 4; ++i) person.touch(kPlaces[i], i == 0 ? Vec3(0.05, 0, 0) : Vec3(0, 0, 0));
    ASSERT_TRUE(person.points.fit());
    ASSERT_GT(person.points.fit()->rms, 0.01);
    person.press_menu();
    EXPECT_EQ(person.points.is_taken(), limit > 0.01);
    if (limit < 0.02) {
      EXPECT_TRUE(person.says("at most 10 mm is kept"));
      EXPECT_TRUE(person.says("Point 1 of 3"));
    }
  }
}

}  // namespace
}  // namespace fulcrum::headset
