#pragma once
// Two models, one to hold and one to touch -> a first scenario: how the tool is held and where it points, a
// place to touch, where to begin, how the device's workspace lies in the scene, where to look from.

#include "haptics/bake/solid.h"
#include "haptics/device/device.h"
#include "haptics/math/pose.h"

namespace fulcrum::app {

struct FirstGuess {
  Vec3 touch_point = Vec3::Zero();  // (3) m in M, the tool's slimmer end
  Vec3 axis = Vec3::UnitY();        // (3) unit in M, from the tool's middle to there
  double length = 0;                // m, of the tool along it
  Pose X_HM;                        // it is held by the other end, the handle's axes along M's
  Pose X_WM_start, X_WM_touch;      // before the place and at it
  Vec3 place = Vec3::Zero();        // (3) m in W, of the touch point when the tool touches
  double radius = 0;                // m, how near counts as there
  double density = 7850;            // kg/m^3; 0: `mass` instead
  double mass = 0.1;                // kg
  double position_scale = 1, force_scale = 1;
  Vec3 base = Vec3::Zero();     // (3) m in W, of the device's origin
  Vec3 look_at = Vec3::Zero();  // (3) m in W
  double look_from = 1;         // m away
  bool is_clear = true;         // on the way to the place the tool is free of the scene
};

// The place is met from above, nearest to the middle of the scene; the tool leans as a pen does, as far as
// that keeps it out of the scene. scene_W and tool_M are solids as build_solid() makes them.
FirstGuess guess_scenario(const Solid& scene_W, const Solid& tool_M, const DeviceDesc& device);

}  // namespace fulcrum::app
