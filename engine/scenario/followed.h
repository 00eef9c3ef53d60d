#pragma once
// What a movable instance may follow (render::Instance::follows), beside the tool, 0, and the device's links,
// 1, 2, ...: more than a device has of these.

#include <cstddef>

namespace fulcrum::scenario {

inline constexpr std::size_t kFollowsGuide = 900;
inline constexpr std::size_t kFollowsHoldingPoint = 901;
inline constexpr std::size_t kFollowsLevelFrame = 902, kFollowsLeftLevel = 903, kFollowsRightLevel = 904;
inline constexpr std::size_t kFollowsImpactCircle = 1000;  // and those after it

inline constexpr std::size_t kFirstFollowed = kFollowsGuide;

}  // namespace fulcrum::scenario
