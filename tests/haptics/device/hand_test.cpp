// The path of a simulated hand. Truths: where it rests it is the minimum-jerk profile, which is written out
// here again; where it goes through, position, velocity and angular velocity are what finite differences find
// on either side.

#include "haptics/device/hand.h"

#include <gtest/gtest.h>

#include <cmath>

#include "haptics/math/rotation.h"

namespace fulcrum::test {
namespace {

Pose pose(double x, double y, double z, const Vec3& turn = Vec3::Zero()) {
  return {quaternion_exp(turn), Vec3(x, y, z)};
}

TEST(HandPath, RestsAtWaypointsAlongTheMinimumJerkProfile) {
  const HandPath path({{pose(0, 0, 0), 0, 0.5}, {pose(0.1, 0, 0, Vec3(0, 1, 0)), 2, 0.5}});
  for (const double s : {0.0, 0.1, 0.37, 0.5, 0.9, 1.0}) {
    const double along = 10 * std::pow(s, 3) - 15 * std::pow(s, 4) + 6 * std::pow(s, 5);
    const Pose at = path.at(0.5 + 2 * s);
    EXPECT_NEAR(at.p.x(), 0.1 * along, 1e-15);
    EXPECT_NEAR(rotation_vector(at.q).y(), along, 1e-12);
  }
  EXPECT_EQ(path.at(-1).p.x(), 0);
  EXPECT_EQ(path.at(9).p.x(), 0.1);
  EXPECT_EQ(path.duration(), 3);
}

std::vector<Waypoint> through_corners() {
  std::vector<Waypoint> waypoints{{pose(0, 0, 0), 0, 0.2},
                                  {pose(0.05, 0.02, 0, Vec3(0.4, 0.1, 0)), 0.5},
                                  {pose(0.08, 0.06, 0.01, Vec3(0.5, 0.6, -0.2)), 0.3},
                                  {pose(0.02, 0.1, 0.05, Vec3(-0.2, 0.7, 0.5)), 0.9, 0.3}};
  waypoints[1].through = waypoints[2].through = true;
  return waypoints;
}

TEST(HandPath, GoesThroughWithoutAJumpInPlaceOrPace) {
  const std::vector<Waypoint> waypoints = through_corners();
  const HandPath path(waypoints);
  constexpr double kStep = 1e-5;
  double time = waypoints[0].dwell;
  for (std::size_t i = 1; i + 1 < waypoints.size(); ++i) {
    SCOPED_TRACE(i);
    time += waypoints[i].travel;
    const Pose before = path.at(time - kStep), at = path.at(time), after = path.at(time + kStep);
    EXPECT_LT((at.p - waypoints[i].X_WT.p).norm(), 1e-12);
    EXPECT_LT(angle_between(at.q, waypoints[i].X_WT.q), 1e-7);
    const Vec3 v_before = (at.p - before.p) / kStep, v_after = (after.p - at.p) / kStep;
    EXPECT_GT(v_after.norm(), 0.05);
    EXPECT_LT((v_after - v_before).norm(), 1e-3 * v_after.norm());
    const Vec3 w_before = rotation_vector(at.q * before.q.conjugate()) / kStep;
    const Vec3 w_after = rotation_vector(after.q * at.q.conjugate()) / kStep;
    EXPECT_GT(w_after.norm(), 0.5);
    EXPECT_LT((w_after - w_before).norm(), 0.01 * w_after.norm());
    // The velocity is that of the straight way from the one before to the one after.
    const Vec3 straight =
        (waypoints[i + 1].X_WT.p - waypoints[i - 1].X_WT.p) / (waypoints[i].travel + waypoints[i + 1].travel);
    EXPECT_LT((v_after - straight).norm(), 1e-3 * straight.norm());
  }
}

// Without acceleration there, too, so that a hand that is pulled along it feels no knock.
TEST(HandPath, GoesThroughWithoutAcceleration) {
  const std::vector<Waypoint> waypoints = through_corners();
  const HandPath path(waypoints);
  constexpr double kStep = 1e-4;
  const double time = waypoints[0].dwell + waypoints[1].travel;
  const auto acceleration = [&](double t) {
    return Vec3((path.at(t + kStep).p - 2 * path.at(t).p + path.at(t - kStep).p) / (kStep * kStep));
  };
  EXPECT_LT(acceleration(time - 2 * kStep).norm(), 0.02);
  EXPECT_LT(acceleration(time + 2 * kStep).norm(), 0.02);
  EXPECT_GT(acceleration(time + 0.1).norm(), 0.1) << "elsewhere there is some";
}

TEST(HandPath, TheFirstAndTheLastAndWhatDwellsAreRestedAt) {
  std::vector<Waypoint> waypoints = through_corners(), resting = waypoints;
  for (Waypoint& waypoint : waypoints) waypoint.through = true;
  for (Waypoint& waypoint : resting) waypoint.through = false;
  waypoints[1].dwell = waypoints[2].dwell = resting[1].dwell = resting[2].dwell = 0.1;
  const HandPath one(waypoints), other(resting);
  for (double t = 0; t < one.duration(); t += 0.01) EXPECT_EQ(one.at(t).p, other.at(t).p);
}

}  // namespace
}  // namespace fulcrum::test
