#pragma once
// Ways that the tests of the guidance lead along, and the commands that switch it.

#include <utility>
#include <vector>

#include "haptics/effects/guidance/guidance.h"

namespace fulcrum::test {

inline constexpr Command kGuidanceOn{Command::Kind::guidance_gain, 1},
    kGuidanceOff{Command::Kind::guidance_gain, 0};
inline constexpr int kRampedIn = 501;  // ticks, in which it has ramped in

inline GuidancePose guided_pose(double time, const Vec3& p, bool rests = false,
                                const Quat& q = Quat::Identity()) {
  return {time, {q, p}, rests};
}

// 0.1 m along x in 2 s, then 0.1 m along y in 1 s.
inline std::vector<GuidancePose> round_a_corner() {
  return {guided_pose(0, {0, 0, 0}), guided_pose(2, {0.1, 0, 0}), guided_pose(3, {0.1, 0.1, 0})};
}

inline GuidanceDesc guidance_along(std::vector<GuidancePose> way) {
  GuidanceDesc desc;
  desc.way = std::move(way);
  desc.dead_band = 2e-3;
  desc.window = 20e-3;
  desc.stiffness = 200;
  desc.max_force = 1;
  return desc;
}

}  // namespace fulcrum::test
