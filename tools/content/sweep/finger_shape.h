#pragma once
// A fingertip from the middle joint on, given by a formula: an axis that bends at the last joint, and an
// oval about it at each place.

#include "tools/content/mesh/profile.h"
#include "tools/content/mesh/solid.h"

namespace fulcrum::content {

class FingerShape {
public:
  FingerShape();

  // Where a point lies: along the axis from the middle of the fingertip (mm, negative towards its end),
  // aside (mm, to the right) and above the axis (mm, towards the nail).
  struct Place {
    double s = 0.0, x = 0.0, h = 0.0;
  };
  Place place(const Eigen::Vector3d& p) const;  // mm
  Eigen::Vector3d point(const Place& place) const;
  Eigen::Vector3d along(double s) const;  // unit, towards the hand
  Eigen::Vector3d above(double s) const;  // unit, towards the nail

  // The oval's surface at s >= 0, at an angle (rad) from the right over the nail, moved out by `off` (mm).
  Eigen::Vector3d surface(double s, double angle, double off) const;

  double bare(const Eigen::Vector3d& p) const;       // about the distance (mm) to the plain surface
  double skin(const Eigen::Vector3d& p) const;       // about the distance (mm) to the surface with its folds
  double nail(const Eigen::Vector3d& p) const;       // about the distance (mm) to the nail
  double from_nail(const Eigen::Vector3d& p) const;  // about how far (mm) outside the nail's outline
  double lowest() const { return lowest_; }          // mm, s of what touches a level plane first

  static constexpr double end = 45.0;         // mm, s where the finger is cut off
  static constexpr double last_joint = 19.0;  // mm, s

private:
  double oval(double s, double x, double h) const;  // 1 on the surface
  double inclination(double s) const;               // rad

  Profile half_width_, over_, under_;
  std::vector<Eigen::Vector2d> axis_;  // (y, z) mm, at every step
  double lowest_ = 0.0;
};

}  // namespace fulcrum::content
