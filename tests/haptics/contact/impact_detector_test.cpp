// A tool of a few points that is led about, in scenes whose distance is a formula; the truth is arithmetic.
// Regions come from the RegionTracker, as in a World.

#include "haptics/contact/impact_detector.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "haptics/math/rotation.h"
#include "haptics/math/split_mix.h"
#include "tests/haptics/geometry/filled_field.h"
#include "tests/haptics/tick_length.h"

namespace fulcrum::test {
namespace {

constexpr double kRegionRadius = 12e-3;  // m
constexpr double kRetreat = 3e-3;        // m
const Vec3 kDown(0, -0.2, 0);            // m/s

struct Plane {
  Vec3 nhat_W;
  double offset;  // m, of the plane along its normal
};

// Convex corners of planes that one is inside of: a floor, a floor with a wall.
class ImpactScene {
public:
  explicit ImpactScene(std::vector<Plane> planes)
      : planes_(std::move(planes)),
        field_(std::make_shared<const DistanceField>(filled_field(4, 6.25e-3, [this](const Vec3& p) {
          double least = std::numeric_limits<double>::infinity();
          for (const Plane& plane : planes_) least = std::min(least, plane.nhat_W.dot(p) - plane.offset);
          return least;
        }))) {}

  std::vector<Contact> touched_by(const std::vector<Vec3>& points_T, const Pose& X_WT) const {
    std::vector<Contact> contacts;
    for (std::size_t i = 0; i < points_T.size(); ++i) {
      const Vec3 p_W = X_WT * points_T[i];
      for (const Plane& plane : planes_) {
        const double depth = plane.offset - plane.nhat_W.dot(p_W);
        if (depth < 0) continue;
        contacts.push_back({static_cast<std::uint32_t>(i), p_W, plane.nhat_W, depth, {}});
      }
    }
    return contacts;
  }
  const std::shared_ptr<const DistanceField>& field() const { return field_; }

private:
  std::vector<Plane> planes_;
  std::shared_ptr<const DistanceField> field_;
};

ImpactScene floor() {
  return ImpactScene({{Vec3::UnitY(), 0.0}});
}

class Led {
public:
  Led(ImpactScene scene, std::vector<Vec3> points_T, const ImpactDetectorDesc& desc = {})
      : scene_(std::move(scene)),
        points_(std::move(points_T)),
        tracker_(kRegionRadius),
        detector_(desc, kRegionRadius, scene_.field(), nullptr) {}

  // The tool at X_WT, the hand with it.
  std::vector<Impact> at(const Pose& X_WT, const Twist& V_WG) {
    contacts_ = scene_.touched_by(points_, X_WT);
    std::vector<Vec3> forces;
    for (const Contact& contact : contacts_) forces.push_back(contact.depth * contact.nhat_W);
    tracker_.update(contacts_, forces, {X_WT, V_WG});
    const auto impacts = detector_.process(
        {.X_WT = X_WT, .X_WG = X_WT, .V_WG = V_WG, .touching = tracker_.touching(contacts_)});
    total_ += impacts.size();
    return {impacts.begin(), impacts.end()};
  }
  std::vector<Impact> at(double y, const Vec3& v = kDown) {
    return at({Quat::Identity(), {0, y, 0}}, {v, Vec3::Zero()});
  }

  // From where it is to `to`, in steps of a tick, at the speed that this takes. Answers the impacts met.
  std::size_t go(const Pose& to, double seconds) {
    const int ticks = static_cast<int>(seconds / kTick);
    const Pose from = here_;
    const Vec3 turn = rotation_vector(to.q * from.q.conjugate());
    const Twist V_WG{(to.p - from.p) / seconds, turn / seconds};
    const std::size_t before = total_;
    for (int i = 1; i <= ticks; ++i) {
      const double part = static_cast<double>(i) / ticks;
      here_ = {quaternion_exp(Vec3(part * turn)) * from.q, from.p + part * (to.p - from.p)};
      at(here_, V_WG);
    }
    return total_ - before;
  }
  std::size_t go(const Vec3& to, double seconds) { return go(Pose{here_.q, to}, seconds); }
  void start(const Pose& X_WT) {
    here_ = X_WT;
    at(here_, {});
  }

  std::size_t total() const { return total_; }
  std::size_t regions() const { return tracker_.regions().size(); }
  std::size_t places() const { return detector_.places(); }

private:
  ImpactScene scene_;
  std::vector<Vec3> points_;
  RegionTracker tracker_;
  ImpactDetector detector_;
  std::vector<Contact> contacts_;
  Pose here_;
  std::size_t total_ = 0;
};

TEST(ImpactDetector, SaysWhereHowAndHowFast) {
  const Vec3 tip(0.05, -0.01, 0.02);
  Led led(floor(), {tip});
  const Quat q = quaternion_exp(Vec3(0, 0, 0.3));
  const Twist V{{0.1, -0.3, 0.05}, {0.4, -1.0, 2.0}};
  EXPECT_TRUE(led.at({q, {0, 0.05, 0}}, V).empty());
  const double height = (q * tip).y();
  const auto impacts = led.at({q, {0, -height - 1e-4, 0}}, V);
  ASSERT_EQ(impacts.size(), 1u);
  const Vec3 r = q * tip;
  EXPECT_LT((impacts[0].p_W - Vec3(r.x(), -1e-4, r.z())).norm(), 1e-12);
  EXPECT_LT((impacts[0].nhat_W - Vec3::UnitY()).norm(), 1e-12);
  EXPECT_NEAR(impacts[0].speed, -(V.v + V.w.cross(r)).y(), 1e-12);
  EXPECT_EQ(impacts[0].object, 0);
}

TEST(ImpactDetector, SpeedIsTheHandsThoughTheToolStandsStill) {
  const ImpactScene scene = floor();
  const auto contacts = scene.touched_by({Vec3::Zero()}, {Quat::Identity(), {0, -1e-6, 0}});
  RegionTracker tracker(kRegionRadius);
  ImpactDetector detector({}, kRegionRadius, scene.field(), nullptr);
  EXPECT_TRUE(detector.process(ImpactDetector::Tick()).empty());
  const std::vector<Vec3> forces{Vec3::UnitY()};
  tracker.update(contacts, forces, {});
  EXPECT_EQ(tracker.regions()[0].approach_speed, 0.0);
  const auto impacts = detector.process({.X_WT = {Quat::Identity(), {0, -1e-6, 0}},
                                         .X_WG = {Quat::Identity(), {0, -2e-3, 0}},
                                         .V_WG = {{0, -0.25, 0}, Vec3::Zero()},
                                         .touching = tracker.touching(contacts)});
  ASSERT_EQ(impacts.size(), 1u);
  EXPECT_NEAR(impacts[0].speed, 0.25, 1e-15);
}

TEST(ImpactDetector, RearmsBeyondTheRetreatAndNotBefore) {
  for (const double retreat : {1e-3, kRetreat, 8e-3}) {
    Led led(floor(), {Vec3::Zero()}, {.retreat = retreat});
    led.at(0.02);
    EXPECT_EQ(led.at(0.0).size(), 1u);
    for (const double height : {0.1, 0.5, 0.99}) {
      led.at(height * retreat, -kDown);
      EXPECT_TRUE(led.at(0.0).empty()) << height;
    }
    led.at(1.01 * retreat, -kDown);
    EXPECT_EQ(led.at(0.0).size(), 1u);
  }
}

TEST(ImpactDetector, FirstTickIsNoImpactAndIsRemembered) {
  Led led(floor(), {Vec3::Zero()});
  EXPECT_TRUE(led.at(0.0).empty());
  led.at(0.002, -kDown);
  EXPECT_TRUE(led.at(0.0).empty());
  led.at(0.0031, -kDown);
  EXPECT_EQ(led.at(0.0).size(), 1u);
}

TEST(ImpactDetector, TouchingWithoutApproachIsNoneAndDisarms) {
  Led led(floor(), {Vec3::Zero()}, {.least_speed = 0.01});
  led.at(0.02);
  EXPECT_TRUE(led.at(-1e-5, {0.5, -0.0099, 0}).empty());
  EXPECT_TRUE(led.at(-2e-5).empty()) << "pressing on is no impact";
  led.at(0.0031);
  EXPECT_TRUE(led.at(-1e-5, -kDown).empty());
  led.at(0.0031);
  EXPECT_EQ(led.at(-1e-5, {0, -0.0101, 0}).size(), 1u);
}

TEST(ImpactDetector, RestingSlidingAndPressingNeverRetrigger) {
  Led led(floor(), {Vec3::Zero()});
  led.start({Quat::Identity(), {-0.08, 0.01, 0}});
  EXPECT_EQ(led.go(Vec3(-0.08, -1e-3, 0), 0.05), 1u);
  EXPECT_EQ(led.go(Vec3(-0.08, -1e-3, 0), 0.1), 0u);
  EXPECT_EQ(led.go(Vec3(0.08, -2e-3, 0.05), 0.3), 0u);
  EXPECT_EQ(led.go(Vec3(0.08, -4e-3, 0.05), 0.02), 0u);
}

// A shaft of points that is drawn over an edge: the scene stays, the tool's point changes.
TEST(ImpactDetector, PlaceGoesAlongWithTheRegionOverTheTool) {
  std::vector<Vec3> shaft;
  for (int i = 0; i <= 160; ++i) shaft.emplace_back(1e-3 * i - 0.08, 0, 0);
  const ImpactScene scene = floor();
  RegionTracker tracker(kRegionRadius);
  ImpactDetector detector({}, kRegionRadius, scene.field(), nullptr);
  detector.process(ImpactDetector::Tick());
  std::size_t impacts = 0;
  for (std::uint32_t i = 0; i < shaft.size(); ++i) {
    // Of the shaft only what lies on the edge, at the origin of W, touches.
    const Pose X_WT{Quat::Identity(), -shaft[i]};
    const std::vector<Contact> contacts{{i, Vec3::Zero(), Vec3::UnitY(), 1e-5, {}}};
    const std::vector<Vec3> forces{Vec3::UnitY()};
    tracker.update(contacts, forces, {});
    const Twist V{{-1.0, -0.2, 0}, Vec3::Zero()};
    impacts +=
        detector.process({.X_WT = X_WT, .X_WG = X_WT, .V_WG = V, .touching = tracker.touching(contacts)})
            .size();
  }
  EXPECT_EQ(impacts, 1u);
}

std::vector<Vec3> face(double half, double spacing) {
  std::vector<Vec3> points;
  for (double x = -half; x <= half + 1e-9; x += spacing)
    for (double z = -half; z <= half + 1e-9; z += spacing) points.emplace_back(x, 0, z);
  return points;
}

// Regions appear, vanish, jump and change their id; the plate never leaves the floor by 3 mm.
TEST(ImpactDetector, RockingPlateStrikesOnce) {
  Led led(floor(), face(0.03, 5e-3));
  led.start({Quat::Identity(), {0, 0.01, 0}});
  EXPECT_EQ(led.go(Pose{Quat::Identity(), {0, -1e-5, 0}}, 0.05), 1u);
  std::size_t most = 0;
  for (int i = 0; i < 12; ++i) {
    const double angle = (i % 2 == 0 ? 1 : -1) * 0.03;
    EXPECT_EQ(led.go(Pose{quaternion_exp(Vec3(i % 3 == 0 ? angle : 0, 0, angle)), {0, 0.0008, 0}}, 0.03), 0u);
    EXPECT_EQ(led.go(Pose{Quat::Identity(), {0, -1e-5, 0}}, 0.03), 0u);
    most = std::max(most, led.places());
  }
  EXPECT_LE(most, ImpactDetector::kPlaces);
}

// Points 20 mm apart are regions of their own; one that fills the gap joins them.
TEST(ImpactDetector, SplitAndMergeAreNoImpacts) {
  Led led(floor(), {{-0.01, 0, 0}, {0, 1e-3, 0}, {0.01, 0, 0}});
  led.at(0.01);
  EXPECT_EQ(led.at(-1e-4).size(), 2u);
  EXPECT_EQ(led.regions(), 2u);
  EXPECT_TRUE(led.at(-1.1e-3).empty());
  EXPECT_EQ(led.regions(), 1u);
  EXPECT_TRUE(led.at(-1e-4).empty());
  EXPECT_EQ(led.regions(), 2u);
}

TEST(ImpactDetector, AnotherPartOfTheToolTriggersAtOnceAndManyDoTogether) {
  Led led(floor(), {{-0.05, 0, 0}, {0.05, 1e-3, 0}});
  led.at(0.01);
  EXPECT_EQ(led.at(0.0).size(), 1u);
  const auto second = led.at(-1.01e-3);
  ASSERT_EQ(second.size(), 1u);
  EXPECT_NEAR(second[0].p_W.x(), 0.05, 1e-12);

  Led four(floor(), {{-0.05, 0, -0.05}, {0.05, 0, -0.05}, {-0.05, 0, 0.05}, {0.05, 0, 0.05}});
  four.at(0.01);
  EXPECT_EQ(four.at(0.0).size(), 4u);
}

// The tip never leaves the floor, and strikes the wall as often as it comes back from beyond the retreat.
TEST(ImpactDetector, SlidingIntoAWallIsAnImpactEachTime) {
  Led led(ImpactScene({{Vec3::UnitY(), 0.0}, {-Vec3::UnitX(), -0.05}}), {Vec3::Zero()});
  led.start({Quat::Identity(), {0, 0.01, 0}});
  EXPECT_EQ(led.go(Vec3(0, -1e-4, 0), 0.05), 1u);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(led.go(Vec3(0.0501, -1e-4, 0), 0.1), 1u);
    EXPECT_EQ(led.go(Vec3(0.048, -1e-4, 0), 0.02), 0u);
    EXPECT_EQ(led.go(Vec3(0.0501, -1e-4, 0), 0.02), 0u) << "within the retreat";
    EXPECT_EQ(led.go(Vec3(0.0, -1e-4, 0), 0.1), 0u);
  }
}

TEST(ImpactDetector, ChatterOnATiltedPlateStrikesOnceForEachRetreat) {
  SplitMix random(7);
  Led led(floor(), face(0.03, 5e-3));
  led.start({Quat::Identity(), {0, 0.02, 0}});
  const Quat tilted = quaternion_exp(Vec3(0.05, 0, 0.08));
  double lowest = 0;
  for (const Vec3& p : face(0.03, 5e-3)) lowest = std::min(lowest, (tilted * p).y());
  EXPECT_EQ(led.go(Pose{tilted, {0, -lowest - 1e-5, 0}}, 0.05), 1u);
  for (int i = 0; i < 200; ++i) {
    const double lift = 2.9e-3 * random.uniform();
    EXPECT_EQ(led.go(Pose{tilted, {0, -lowest + lift, 0}}, 5e-3), 0u);
    EXPECT_EQ(led.go(Pose{tilted, {0, -lowest - 1e-5, 0}}, 5e-3), 0u) << lift;
  }
}

// Against the state machine that the words describe, for one point over a floor.
TEST(ImpactDetector, RandomHeightsAgainstTheRule) {
  SplitMix random(3);
  Led led(floor(), {Vec3::Zero()});
  bool armed = true;
  double y = 0.01;
  led.at(y);
  std::size_t struck = 0;
  for (int i = 0; i < 20000; ++i) {
    const double next = std::clamp(y + 4e-3 * (random.uniform() - 0.5), -1e-3, 6e-3);
    const double speed = (y - next) / kTick;
    y = next;
    if (y > kRetreat) armed = true;
    const bool expected = y <= 0 && armed && speed > ImpactDetectorDesc{}.least_speed;
    if (y <= 0) armed = false;
    ASSERT_EQ(led.at(y, {0, -speed, 0}).size(), expected ? 1u : 0u) << "tick " << i;
    struck += expected ? 1 : 0;
  }
  EXPECT_GT(struck, 100u);
}

TEST(ImpactDetector, AsManyContactsAsThereCanBeStrikeOnce) {
  Led led(floor(), face(0.085, 0.0113));  // 256 points
  led.at(0.01);
  EXPECT_GE(led.at(-1e-5).size(), 1u);
  EXPECT_LE(led.places(), ImpactDetector::kPlaces);
  for (int i = 0; i < 50; ++i) EXPECT_TRUE(led.at(-1e-5).empty());
}

// 25 feet of eight points each: more places than the feet that were remembered last.
TEST(ImpactDetector, ManyFeetThatStandAreNotStruckAgain) {
  std::vector<Vec3> points;
  for (int foot = 0; foot < 25; ++foot)
    for (int i = 0; i < 8; ++i)
      points.emplace_back(0.05 * (foot % 5) + 7e-3 * (i % 4), 0, 0.05 * (foot / 5) + 7e-3 * (i / 4));
  Led led(floor(), points);
  led.at(0.01);
  EXPECT_EQ(led.at(-1e-5).size(), 25u);
  for (int i = 0; i < 50; ++i) EXPECT_TRUE(led.at(-1e-5).empty()) << i;
}

TEST(ImpactDetector, ASpeedThatIsNotANumberIsNoImpact) {
  Led led(floor(), {Vec3::Zero()});
  led.at(0.01);
  EXPECT_TRUE(led.at(-1e-5, Vec3::Constant(std::numeric_limits<double>::quiet_NaN())).empty());
}

}  // namespace
}  // namespace fulcrum::test
