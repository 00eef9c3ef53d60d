#pragma once
// What a headset's runtime says of places, taken where it can be true: a runtime is another program, and what
// it says moves a tool.

#include <optional>

#include "engine/xr/openxr.h"
#include "haptics/math/pose.h"

namespace fulcrum::xr {

// m, from its space's origin: no room that a headset is worn in is larger.
inline constexpr double kFarthest = 100;
// Of a quaternion's length from 1. OpenXR refuses what a program gives that is farther off (The OpenXR
// Specification 1.0, "Coordinate System"); we ask the same of it.
inline constexpr double kTurnError = 0.01;
// m/s and rad/s: no hand is as fast. One that cameras see go faster has been taken for something else, or
// found anew.
inline constexpr double kFastest = 8, kFastestTurn = 40;

// None: it is no number, no turn, or too far away.
std::optional<Vec3> credible(const XrVector3f& p);
std::optional<Pose> credible(const XrPosef& pose);

// rad: no headset shows less, and what is drawn for it has to be wider than nothing.
inline constexpr double kNarrowestView = 0.05;
// Each angle is a number within a right angle (The OpenXR Specification 1.0, "Angles"), and left is left of
// right as down is below up.
bool is_credible(const XrFovf& fov);

// One hand from picture to picture. Where it leaps, it is out of sight for that picture: whoever follows it
// takes it anew.
class Sighting {
public:
  // X: what was seen; none: nothing. time: ns, for which that is. None: nothing that follows what was seen
  // before.
  std::optional<Pose> follow(const std::optional<Pose>& X, XrTime time);

private:
  std::optional<Pose> before_;
  XrTime picture_at_ = 0;  // ns, of the newest picture
  XrTime here_at_ = 0;     // ns, of the first picture in which it was there
};

}  // namespace fulcrum::xr
