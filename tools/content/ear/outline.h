#pragma once

#include <vector>

#include <Eigen/Core>

namespace fulcrum::content {

// A smooth closed line in a plane, through its corners.
class Outline {
public:
  explicit Outline(const std::vector<Eigen::Vector2d>& corners);  // mm
  // The distance (mm) to the line, negative within it.
  double distance(const Eigen::Vector2d& p) const;

private:
  std::vector<Eigen::Vector2d> points_;
};

}  // namespace fulcrum::content
