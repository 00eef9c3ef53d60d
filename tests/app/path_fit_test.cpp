// A recorded motion as waypoints. The truth is the motion that was made up here; the path is walked by the
// hand's own interpolation and measured at every sample.

#include "engine/app/author/path_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "haptics/math/rotation.h"
#include "haptics/math/split_mix.h"

namespace fulcrum::app {
namespace {

constexpr double kTick = 1e-3;

std::vector<Pose> sampled(double duration, const std::function<Pose(double)>& motion) {
  std::vector<Pose> samples;
  for (int i = 0; i * kTick < duration; ++i) samples.push_back(motion(i * kTick));
  return samples;
}

// A second of rest, a turn and a half of a helix in three seconds, and two seconds of rest.
Pose helix(double time) {
  const double t = std::clamp((time - 1) / 3, 0.0, 1.0);
  const double s = t * t * (3 - 2 * t), angle = 3 * std::numbers::pi * s;
  return {quaternion_exp(Vec3(0, 0.5 * angle, 0)),
          Vec3(0.05 * std::cos(angle), 0.04 * s, 0.05 * std::sin(angle))};
}

void expect_within(const FittedPath& fitted, const std::vector<Pose>& samples, double position,
                   double angle) {
  const HandPath path(fitted.waypoints);
  double largest = 0, largest_angle = 0;
  const auto begin = static_cast<std::size_t>(std::lround(fitted.trimmed_start / kTick));
  for (std::size_t i = begin; i < samples.size(); ++i) {
    const Pose at = path.at(static_cast<double>(i - begin) * kTick);
    largest = std::max(largest, (at.p - samples[i].p).norm());
    largest_angle = std::max(largest_angle, angle_between(at.q, samples[i].q));
  }
  EXPECT_LE(largest, position);
  EXPECT_LE(largest_angle, angle);
  EXPECT_NEAR(fitted.position_error, largest, 1e-9) << "what it says is what it is";
  EXPECT_NEAR(fitted.angle_error_rad, largest_angle, 1e-9);
  EXPECT_NEAR(path.duration(), static_cast<double>(samples.size() - 1 - begin) * kTick, 1e-6);
}

TEST(PathFit, StaysWithinItsToleranceWithFewerWaypointsWhereItIsWider) {
  const std::vector<Pose> samples = sampled(6, helix);
  std::size_t before = samples.size();
  for (const double tolerance : {0.05e-3, 0.5e-3, 5e-3}) {
    SCOPED_TRACE(tolerance);
    const FittedPath fitted = fit_path(samples, kTick, {tolerance, 40 * tolerance});
    expect_within(fitted, samples, tolerance, 40 * tolerance);
    EXPECT_LT(fitted.waypoints.size(), before);
    before = fitted.waypoints.size();
  }
  EXPECT_LE(before, 12u);
}

TEST(PathFit, RestsWhereItRestedAndCutsTheRestBeforeIt) {
  const std::vector<Pose> samples = sampled(6, helix);
  const FittedPath fitted = fit_path(samples, kTick, {});
  EXPECT_NEAR(fitted.waypoints.front().dwell, 0.5, 0.01);
  EXPECT_NEAR(fitted.trimmed_start, 0.5, 0.1);
  EXPECT_GT(fitted.waypoints.back().dwell, 1.8);
  for (std::size_t i = 1; i + 1 < fitted.waypoints.size(); ++i) EXPECT_TRUE(fitted.waypoints[i].through);
}

TEST(PathFit, LeavesTremorOut) {
  SplitMix random(1);
  const std::vector<Pose> samples = sampled(6, [&](double time) {
    Pose pose = helix(time);
    pose.p += 1e-4 * Vec3(std::sin(55 * time), std::sin(63 * time + 1), std::sin(70 * time + 2));
    return pose;
  });
  const FittedPath fitted = fit_path(samples, kTick, {});
  expect_within(fitted, samples, 0.5e-3, 0.02);
  EXPECT_LE(fitted.waypoints.size(), 2 * fit_path(sampled(6, helix), kTick, {}).waypoints.size());
}

// Of a steady motion along a line the path is as steady: it does not stop at each waypoint.
TEST(PathFit, KeepsThePace) {
  const std::vector<Pose> samples = sampled(4, [](double time) {
    const double t = std::clamp(time - 0.5, 0.0, 3.0);
    return Pose{Quat::Identity(), Vec3(0.03 * t, 0.002 * std::sin(4 * t), 0)};
  });
  const HandPath path(fit_path(samples, kTick, {}).waypoints);
  for (double t = 1; t < 2.5; t += 0.01) {
    const double pace = (path.at(t + 0.005).p - path.at(t - 0.005).p).norm() / 0.01;
    EXPECT_GT(pace, 0.5 * 0.03) << t;
    EXPECT_LT(pace, 1.6 * 0.03) << t;
  }
}

TEST(PathFit, WhatNeverMovedIsARest) {
  for (const double duration : {0.0005, 0.002, 3.0}) {
    const std::vector<Pose> samples = sampled(duration, [](double) { return Pose{}; });
    const FittedPath fitted = fit_path(samples, kTick, {});
    EXPECT_EQ(fitted.waypoints.size(), 2u);
    EXPECT_EQ(fitted.position_error, 0);
    for (std::size_t i = 1; i < fitted.waypoints.size(); ++i) EXPECT_GT(fitted.waypoints[i].travel, 0);
  }
}

}  // namespace
}  // namespace fulcrum::app
