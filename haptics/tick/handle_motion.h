#pragma once
// How the handle moves in one tick, as far as a device can tell.

#include "haptics/math/linear.h"
#include "haptics/math/pose.h"

namespace fulcrum {

// Frames: W the scene, D the device, H the handle, G where the hand wants the tool T, or where it holds it.
struct HandleMotion {
  Pose X_DH;   // the handle, by the last sample that could be used
  Pose X_WH;   // the same in the scene: mapped, and carried on by clutch and drift
  Twist V_WH;  // of X_WH, estimated, as late as SceneDesc::velocity lets it be
  Pose X_WG;   // where the hand wants the tool
  Twist V_WG;

  // (6) m and rad, counted since the sample before: the handle's own way, without the mapping's drift. While
  // the clutch is pressed it is 0, unless an effect pushes then (ListedEffect::kPushesWhileClutched).
  Vec6 moved_D = Vec6::Zero();
  Vec6 within_tick_D = Vec6::Zero();  // (6) m and rad, the part of it that fell within this tick
  Vec6 per_tick_D = Vec6::Zero();     // (6) m and rad per tick, known between two counts too
  double sample_age = 0;              // s, of the sample
  Vec3 drifted_W = Vec3::Zero();      // (3) m, by which drift has carried X_WH on since the start

  double place = 0;            // m along the stick from H, where the hand holds it; 0: no scene says
  Vec3 p_TG = Vec3::Zero();    // (3) m, the same place on the tool, in T
  Vec3 p_HG_D = Vec3::Zero();  // (3) m at the device, the same place from H
  bool engaged = true;         // the hand holds the tool: the clutch is not pressed
};

}  // namespace fulcrum
