#pragma once
// A recorded motion -> the waypoints of a simulated hand: as few as stay within a tolerance, with rests where
// it rested. What the hand trembled by less than the tolerance is gone.

#include <span>
#include <vector>

#include "haptics/device/hand.h"

namespace fulcrum::app {

struct PathTolerance {
  double position = 5e-4;  // m, of the tool model's origin
  double angle_rad = 0.02;
};

struct FittedPath {
  std::vector<Waypoint> waypoints;  // at least two
  double position_error = 0;        // m, the largest to a sample, measured
  double angle_error_rad = 0;       // likewise
  double trimmed_start = 0;         // s, of rest before the first motion that is left out
};

// samples: of the tool's model in the world, one each tick_s; at least one. A rest before the first motion is
// cut to half a second.
FittedPath fit_path(std::span<const Pose> samples, double tick_s, const PathTolerance& tolerance);

}  // namespace fulcrum::app
