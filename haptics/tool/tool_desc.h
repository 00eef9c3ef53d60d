#pragma once
// The tool that a hand holds, as a body.

#include "haptics/math/linear.h"
#include "haptics/math/pose.h"

namespace fulcrum {

struct ToolDesc {
  double mass = 0.2;                  // kg
  Mat3 inertia_T = Mat3::Identity();  // (3 x 3) kg m^2, about the centre of mass, in T
  Pose X_HT;                          // the tool in the handle, when nothing touches it
  Pose X_WT_start;                    // where the tool is at tick 0
  bool weight = true;                 // gravity acts on the tool, and the hand feels it
};

// N
inline double tool_weight(const ToolDesc& tool) {
  constexpr double gravity = 9.80665;  // m/s^2
  return tool.weight ? gravity * tool.mass : 0.0;
}

}  // namespace fulcrum
