#include "engine/xr/hand_tracking.h"

#include "engine/xr/credible.h"

namespace fulcrum::xr {
namespace {

// Seen, not guessed: a runtime may go on saying where a hand was.
constexpr XrSpaceLocationFlags kPoseIsSeen =
    XR_SPACE_LOCATION_ORIENTATION_VALID_BIT | XR_SPACE_LOCATION_POSITION_VALID_BIT |
    XR_SPACE_LOCATION_ORIENTATION_TRACKED_BIT | XR_SPACE_LOCATION_POSITION_TRACKED_BIT;
constexpr double kLongestHand = 0.3;  // m, from the palm's middle to a tip: twice a large one's

std::optional<Vec3> tip(const XrHandJointLocationsEXT& locations, XrHandJointEXT joint) {
  const XrHandJointLocationEXT& location = locations.jointLocations[joint];
  if ((location.locationFlags & XR_SPACE_LOCATION_POSITION_VALID_BIT) == 0) return std::nullopt;
  return credible(location.pose.position);
}

}  // namespace

std::optional<HandJoints> joints_of(const XrHandJointLocationsEXT& locations) {
  if (locations.isActive != XR_TRUE) return std::nullopt;
  const XrHandJointLocationEXT& palm = locations.jointLocations[XR_HAND_JOINT_PALM_EXT];
  if ((palm.locationFlags & kPoseIsSeen) != kPoseIsSeen) return std::nullopt;
  const std::optional<Pose> X_LP = credible(palm.pose);
  const std::optional<Vec3> thumb = tip(locations, XR_HAND_JOINT_THUMB_TIP_EXT),
                            index = tip(locations, XR_HAND_JOINT_INDEX_TIP_EXT),
                            little = tip(locations, XR_HAND_JOINT_LITTLE_TIP_EXT);
  if (!X_LP || !thumb || !index || !little) return std::nullopt;
  for (const Vec3& p_LTip : {*thumb, *index, *little})
    if ((p_LTip - X_LP->p).norm() > kLongestHand) return std::nullopt;
  return HandJoints{*X_LP, *thumb, *index, *little};
}

HandTracking::HandTracking(Session& session)
    : session_(session),
      locate_(session.instance().function<PFN_xrLocateHandJointsEXT>("xrLocateHandJointsEXT")),
      destroy_(session.instance().function<PFN_xrDestroyHandTrackerEXT>("xrDestroyHandTrackerEXT")) {
  const auto create = session.instance().function<PFN_xrCreateHandTrackerEXT>("xrCreateHandTrackerEXT");
  auto info = structure<XrHandTrackerCreateInfoEXT>(XR_TYPE_HAND_TRACKER_CREATE_INFO_EXT);
  info.handJointSet = XR_HAND_JOINT_SET_DEFAULT_EXT;
  try {
    for (std::size_t hand = 0; hand < trackers_.size(); ++hand) {
      info.hand = hand == 0 ? XR_HAND_LEFT_EXT : XR_HAND_RIGHT_EXT;
      check(create(session.get(), &info, &trackers_[hand]), "track hands");
    }
  } catch (const Failure&) {
    if (trackers_[0] != XR_NULL_HANDLE) destroy_(trackers_[0]);
    throw;
  }
}

HandTracking::~HandTracking() {
  for (const XrHandTrackerEXT tracker : trackers_) destroy_(tracker);
}

std::array<std::optional<HandJoints>, 2> HandTracking::read(const Frame& frame) {
  auto info = structure<XrHandJointsLocateInfoEXT>(XR_TYPE_HAND_JOINTS_LOCATE_INFO_EXT);
  info.baseSpace = session_.space();
  info.time = frame.display_time;
  std::array<std::optional<HandJoints>, 2> hands;
  for (std::size_t hand = 0; hand < hands.size(); ++hand) {
    std::array<XrHandJointLocationEXT, XR_HAND_JOINT_COUNT_EXT> joints{};
    auto locations = structure<XrHandJointLocationsEXT>(XR_TYPE_HAND_JOINT_LOCATIONS_EXT);
    locations.jointCount = static_cast<std::uint32_t>(joints.size());
    locations.jointLocations = joints.data();
    if (session_.goes_on(locate_(trackers_[hand], &info, &locations), "say where hands are"))
      hands[hand] = joints_of(locations);
  }
  return hands;
}

}  // namespace fulcrum::xr
