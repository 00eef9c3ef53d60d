#pragma once

#include <vector>

#include <Eigen/Geometry>

namespace fulcrum::content {

// A place on the axis of a cord, and the cord's radius there.
struct Knot3 {
  Eigen::Vector3d p;  // mm
  double r = 0.0;     // mm
};

// A round cord through its knots: E. Catmull and R. Rom, "A class of local interpolating splines", 1974.
class Cord {
public:
  explicit Cord(const std::vector<Knot3>& knots);
  // About the distance (mm) to its surface, negative inside. Farther than `reach` it is a lower bound.
  double distance(const Eigen::Vector3d& p) const;

  static constexpr double reach = 6.0;  // mm

private:
  std::vector<Knot3> knots_;  // close to each other
  Eigen::AlignedBox3d box_;
};

}  // namespace fulcrum::content
