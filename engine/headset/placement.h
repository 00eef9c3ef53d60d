#pragma once
// Where a scene is in the space of who wears a headset.
//
// L is the headset's space: its y axis is up, and -z is ahead of who was there when it was recentred. W is
// the scene's world.

#include "engine/app/cli/headset_options.h"
#include "engine/render/visual_desc.h"
#include "engine/xr/session.h"
#include "haptics/math/pose.h"

namespace fulcrum::headset {

// The turn about the vertical that takes -z to where `ahead` goes; of one that is vertical itself, none.
Quat heading(const Vec3& ahead);

struct Placement {
  Pose X_WL;
  double scale = 1;  // so many m in L are one in W

  // What is there in L, in W; the frame's axes are as long as before.
  Pose in_world(const Pose& X_L) const { return {X_WL.q * X_L.q, X_WL.q * (X_L.p / scale) + X_WL.p}; }
};

// Ahead is where the view looks, turned about the vertical alone, so that the scene's floor is level. In
// local space the head begins where the view's eye is, on its line to the target, and never nearer to that
// than kNearest. In stage space the target is above the middle of the floor, at kBench.
Placement place_scene(const render::Camera& view, const app::HeadsetOptions& options);

// The device's base D, which the scene has at X_WD, is at X_LD; what the device maps to the scene
// position_scale times as large is seen as large as it is felt.
Placement place_on_device(const Pose& X_WD, double position_scale, const Pose& X_LD);

inline constexpr double kNearest = 0.4;  // m in L: what is nearer tires the eyes
inline constexpr double kBench = 1.1;    // m in L: for the hands of who stands

// What an eye sees, as a camera in W that looks wherever the eye does. layers: of the instances that are
// seen.
render::Camera eye_camera(const xr::EyeView& eye, const Placement& placement, std::uint32_t layers);

}  // namespace fulcrum::headset
