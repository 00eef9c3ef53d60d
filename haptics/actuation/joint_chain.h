#pragma once
// One arm of a device: where its joints are at given angles, and which angles take its end somewhere.
//
// Forward: joints are screws in the pose in which all angles are 0, turned by those before them (product of
// exponentials; K. M. Lynch, F. C. Park, "Modern Robotics", 2017, 4.1). Inverse: Levenberg-Marquardt steps
// from the angles of the tick before, within the joints' stops; two or three are enough for a tick of a hand.

#include <array>
#include <span>

#include "haptics/device/mechanism_desc.h"

namespace fulcrum {

inline constexpr int kMaxJoints = 6;

// (rad), one for each joint of an arm.
using JointAngles = std::array<double, kMaxJoints>;

class JointChain {
public:
  // X_DK: the table's frame.
  JointChain(const ArmDesc& arm, const Pose& X_DK);

  struct Placed {
    std::array<Vec3, kMaxJoints> axis_D;   // (joints x 3) unit
    std::array<Vec3, kMaxJoints> point_D;  // (joints x 3) m
    Pose X_DE;                             // the arm's end; its axes are D's where all angles are 0
  };
  Placed place(const JointAngles& angles) const noexcept;

  // Columns: what each joint does to the end's velocity, and of an arm of six to its angular velocity, in D.
  // (3 x 3) m or (6 x 6) m; 1. Rows and columns are those of the joints' own angles.
  using Jacobian = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 6, 6>;
  Jacobian jacobian(const Placed& placed) const noexcept;

  // Angles, and where the joints are there: finding that out takes a third of a tick of an arm, and each tick
  // begins where the one before has ended.
  struct Posture {
    JointAngles angles;  // (joints) rad
    Placed placed;       // place(angles)
  };
  Posture posture(const JointAngles& angles) const noexcept { return {angles, place(angles)}; }

  // Moves the arm to where its end is at X_DE, as near as the joints' stops allow: of an arm of three joints
  // its position alone. Answers how far it stays away, m, with kLever for each rad.
  double reach(const Pose& X_DE, Posture& arm) const noexcept;

  int joints() const { return joints_; }
  JointAngles home() const { return home_; }
  const Vec3& end_D() const { return end_D_; }  // (3) m, all angles 0
  bool through_parallelogram(int joint) const { return parallelogram_[static_cast<std::size_t>(joint)]; }

  static constexpr double kLever = 0.1;  // m/rad, what a turn counts beside a displacement

private:
  using Offset = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 6, 1>;
  Offset offset(const Pose& X_DE, const Placed& placed) const noexcept;  // (joints) m
  double descend(const Pose& X_DE, Posture& arm, int steps) const noexcept;

  int joints_;
  std::array<Vec3, kMaxJoints> axis_D_{}, point_D_{};
  Vec3 end_D_;
  JointAngles home_{}, low_{}, high_{};
  std::array<bool, kMaxJoints> parallelogram_{};
};

}  // namespace fulcrum
