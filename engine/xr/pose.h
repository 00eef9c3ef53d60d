#pragma once
// Poses of OpenXR, whose axes are ours: x to the right, y up, z to the back.

#include "engine/xr/openxr.h"
#include "haptics/math/pose.h"

namespace fulcrum::xr {

inline Pose pose_of(const XrPosef& pose) {
  const XrQuaternionf& q = pose.orientation;
  const XrVector3f& p = pose.position;
  return {Quat(static_cast<double>(q.w), static_cast<double>(q.x), static_cast<double>(q.y),
               static_cast<double>(q.z))
              .normalized(),
          Vec3(static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z))};
}

inline XrPosef to_xr(const Pose& X) {
  return {{static_cast<float>(X.q.x()), static_cast<float>(X.q.y()), static_cast<float>(X.q.z()),
           static_cast<float>(X.q.w())},
          {static_cast<float>(X.p.x()), static_cast<float>(X.p.y()), static_cast<float>(X.p.z())}};
}

}  // namespace fulcrum::xr
