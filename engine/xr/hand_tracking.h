#pragma once
// Hands without controllers, as the headset's cameras see them (The OpenXR Specification 1.0,
// XR_EXT_hand_tracking). Of a hand's 26 joints four are read.

#include <array>
#include <optional>

#include "engine/xr/session.h"

namespace fulcrum::xr {

// Of one hand, when a frame will be seen.
struct HandJoints {
  Pose X_LP;                           // its palm
  Vec3 p_LThumb, p_LIndex, p_LLittle;  // (3) m, the fingers' tips
};

// What a runtime says of a hand, if all four can be true; none: the hand is out of sight.
std::optional<HandJoints> joints_of(const XrHandJointLocationsEXT& locations);

class HandTracking {
public:
  // The session outlives it, and its instance has been asked for hands. Throws Failure.
  explicit HandTracking(Session& session);
  ~HandTracking();
  HandTracking(const HandTracking&) = delete;
  HandTracking& operator=(const HandTracking&) = delete;

  // Left, right.
  std::array<std::optional<HandJoints>, 2> read(const Frame& frame);

private:
  Session& session_;
  PFN_xrLocateHandJointsEXT locate_;
  PFN_xrDestroyHandTrackerEXT destroy_;
  std::array<XrHandTrackerEXT, 2> trackers_{XR_NULL_HANDLE, XR_NULL_HANDLE};
};

}  // namespace fulcrum::xr
