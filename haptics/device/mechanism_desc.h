#pragma once
// The links and joints of a haptic device, as a table. actuation/mechanism.h makes of it what ticks.
//
// K is the frame in which the table was written down, the maker's or a paper's. The device's frame D has its
// origin where the handle is when every joint is at its `home`, and q_DK turns the table's axes into D's. The
// handle's frame H lies on D at home: no figure of it has to be known.

#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "haptics/math/pose.h"

namespace fulcrum {

// One revolute joint with a motor, placed where it is when the angles of all joints are 0.
struct JointDesc {
  std::string name;
  Vec3 axis_K = Vec3::UnitZ();     // (3), need not be unit; positive turns are right-handed
  Vec3 point_K = Vec3::Zero();     // (3) m, any point of the axis
  double home = 0;                 // rad
  double low = -std::numbers::pi;  // rad, the joint's stops
  double high = std::numbers::pi;  // rad
  double max_torque = 1;           // N m, at the joint
  // The motor sits before the joint in front of this one and turns the link through a parallelogram: what it
  // sets is this link's angle against that body, the sum of both joints' angles.
  bool through_parallelogram = false;
};

// Joints from the base to the handle. With three of them the arm holds a point of the handle by a gimbal and
// pushes alone; with six the last link is the handle.
struct ArmDesc {
  std::string name;
  std::vector<JointDesc> joints;
  Vec3 end_K = Vec3::Zero();  // (3) m, the arm's end, all angles 0
};

// A motor on the handle that turns it about the line from the first arm's end to the second's.
struct SpinDesc {
  std::string name;
  double ratio = 1;       // turns of the handle for one of the motor
  double max_torque = 1;  // N m, at the motor
};

struct MechanismDesc {
  Quat q_DK = Quat::Identity();
  std::vector<ArmDesc> arms;     // one or two; the first one's end is H's origin
  std::optional<SpinDesc> spin;  // with two arms of three joints
};

}  // namespace fulcrum
