// Hands without controllers, by XR_EXT_hand_tracking.

#include <limits>
#include <string>

#include "engine/xr/pose.h"
#include "tests/xr/runtime/calls.h"
#include "tests/xr/runtime/headset.h"
#include "tests/xr/runtime/log.h"

namespace runtime {
namespace {

using fulcrum::Quat;
using fulcrum::Vec3;

constexpr std::array<int, 5> kTips{XR_HAND_JOINT_THUMB_TIP_EXT, XR_HAND_JOINT_INDEX_TIP_EXT,
                                   XR_HAND_JOINT_MIDDLE_TIP_EXT, XR_HAND_JOINT_RING_TIP_EXT,
                                   XR_HAND_JOINT_LITTLE_TIP_EXT};

// (3) m, in the palm of a hand that points along its -z with the back of it up. The thumb's tip rests; each
// finger stretches from its knuckle towards where its tip is asked to be.
Vec3 joint_in_palm(const BareHand& hand, std::size_t joint) {
  const Vec3 thumb(-0.02, -0.03, -0.08);
  if (joint == XR_HAND_JOINT_PALM_EXT) return Vec3::Zero();
  if (joint == XR_HAND_JOINT_WRIST_EXT) return {0, 0, 0.07};
  std::size_t finger = 0;
  while (static_cast<int>(joint) > kTips[finger]) ++finger;
  const Vec3 knuckle(0.02 * static_cast<double>(finger) - 0.05, 0, finger == 0 ? 0.04 : -0.03);
  Vec3 tip = knuckle + Vec3(0, 0, -0.08);
  if (finger == 0) tip = thumb;
  if (finger == 1) tip = thumb + Vec3(0, hand.to_index, 0);
  if (finger == 4) tip = thumb + Vec3(hand.to_little, 0, 0);
  const double missing = 0.25 * (kTips[finger] - static_cast<int>(joint));
  return tip + missing * (knuckle - tip);
}

void spoil(XrPosef& pose, const std::string& how) {
  if (how == "nan") pose.position.x = std::numeric_limits<float>::quiet_NaN();
  if (how == "unturned") pose.orientation = {0, 0, 0, 0.5F};
  if (how == "far") pose.position.y = 3e7F;
}

XrResult XRAPI_CALL create_tracker(XrSession, const XrHandTrackerCreateInfoEXT* info,
                                   XrHandTrackerEXT* made) {
  const std::size_t hand = info->hand == XR_HAND_RIGHT_EXT ? 1 : 0;
  log(std::string("xrCreateHandTrackerEXT ") + (hand == 1 ? "right" : "left"));
  if (headset->session->lost) return XR_ERROR_SESSION_LOST;
  auto& trackers = headset->session->trackers;
  trackers.push_back(std::make_unique<HandTracker>(HandTracker{hand}));
  *made = handle_of<XrHandTrackerEXT>(trackers.back().get());
  return XR_SUCCESS;
}

XrResult XRAPI_CALL destroy_tracker(XrHandTrackerEXT tracker) {
  log("xrDestroyHandTrackerEXT");
  std::erase_if(headset->session->trackers,
                [&](const auto& one) { return handle_of<XrHandTrackerEXT>(one.get()) == tracker; });
  return XR_SUCCESS;
}

XrResult XRAPI_CALL locate_joints(XrHandTrackerEXT tracker, const XrHandJointsLocateInfoEXT* info,
                                  XrHandJointLocationsEXT* locations) {
  if (headset->session->lost) return XR_ERROR_SESSION_LOST;
  if (info->time != headset->time) wrong("hands are asked for at a time that no frame is for");
  if (locations->jointCount != XR_HAND_JOINT_COUNT_EXT) {
    wrong("a hand has other joints");
    return XR_ERROR_VALIDATION_FAILURE;
  }
  const BareHand& hand = headset->bare[reinterpret_cast<const HandTracker*>(tracker)->hand];
  const Pose X_BP = pose_of(*reinterpret_cast<const Space*>(info->baseSpace)).inverse() * hand.X_LP;
  const bool seen = hand.there && !hand.covered;
  locations->isActive = seen ? XR_TRUE : XR_FALSE;
  for (std::size_t joint = 0; joint < XR_HAND_JOINT_COUNT_EXT; ++joint) {
    XrHandJointLocationEXT& location = locations->jointLocations[joint];
    location.locationFlags =
        seen ? XR_SPACE_LOCATION_ORIENTATION_VALID_BIT | XR_SPACE_LOCATION_POSITION_VALID_BIT |
                   XR_SPACE_LOCATION_ORIENTATION_TRACKED_BIT | XR_SPACE_LOCATION_POSITION_TRACKED_BIT
             : 0;
    location.pose = fulcrum::xr::to_xr(X_BP * Pose{Quat::Identity(), joint_in_palm(hand, joint)});
    location.radius = 0.008F;
  }
  spoil(locations->jointLocations[XR_HAND_JOINT_PALM_EXT].pose, hand.spoilt);
  return XR_SUCCESS;
}

}  // namespace

std::span<const Call> hand_calls() {
  static const std::array calls{Call{"xrCreateHandTrackerEXT", erased(create_tracker)},
                                Call{"xrDestroyHandTrackerEXT", erased(destroy_tracker)},
                                Call{"xrLocateHandJointsEXT", erased(locate_joints)}};
  if (!headset || !headset->tracks_hands) return {};
  return calls;
}

}  // namespace runtime
