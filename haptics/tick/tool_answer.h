#pragma once
// How the tool answered in one tick.

#include "haptics/math/pose.h"
#include "haptics/math/wrench.h"

namespace fulcrum {

// Both wrenches are on the tool, about T where it was when they acted.
struct ToolAnswer {
  Pose X_WT;
  Wrench coupling_F_T_W;
  Wrench contact_F_T_W;
  Vec3 full_torque_T_W = Vec3::Zero();  // (3) N m, the coupling's if nothing limited it
  Vec3 turn_W = Vec3::Zero();           // (3) rad, by which its spring is wound: from the tool to the hand
};

}  // namespace fulcrum
