#pragma once
// What the surroundings do to the colour of a point: how much light reaches it, and from what.

#include <algorithm>
#include <cmath>

#include "tools/content/teeth/gum.h"

namespace fulcrum::content {

inline Eigen::Vector3d mixed(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double t) {
  return a + std::clamp(t, 0.0, 1.0) * (b - a);
}

// How much of the sky a point sees, from how fast what is around it recedes along the normal (A. Evans, "Fast
// Approximations for Global Illumination on Dynamic Scenes", SIGGRAPH 2006 course). Points in mm.
template <typename Distance>
double openness(const Distance& scene, const Eigen::Vector3d& p, const Eigen::Vector3d& n) {
  double shut = 0.0;
  double weight = 0.0;
  for (const double far : {0.25, 0.6, 1.3, 2.6}) {
    const double share = 1.0 / (0.6 + far);
    shut += share * std::clamp((far - scene(p + far * n)) / far, 0.0, 1.0);
    weight += share;
  }
  return std::clamp(1.0 - shut / weight, 0.0, 1.0);
}

// Light that gets into a hollow has been on its walls before: what is shut in gains their colour.
inline Eigen::Vector3d shut_in(const Eigen::Vector3d& colour, double open, const Eigen::Vector3d& walls) {
  const Eigen::Vector3d bounced = Eigen::Vector3d::Constant(0.25) + 0.75 * walls;
  return colour.cwiseProduct(mixed(0.55 * bounced, Eigen::Vector3d::Ones(), open));
}

// mm, to a tooth and its neighbours.
inline double teeth_distance(const Dentition& dentition, std::size_t around, const Eigen::Vector3d& p) {
  double least = 1e3;
  const std::size_t last = dentition.teeth.size() - 1;
  for (std::size_t i = around == 0 ? 0 : around - 1; i <= std::min(around + 1, last); ++i) {
    least = std::min(least, dentition.teeth[i].distance(p));
  }
  return least;
}

// Smooth noise of about unit size, without any table.
inline double mottle(const Eigen::Vector3d& p) {
  return std::sin(p.x() + 1.7 * std::sin(0.7 * p.y() + 0.4 * p.z())) *
         std::sin(p.y() + 1.3 * std::sin(0.8 * p.z() - 0.3 * p.x())) *
         std::sin(p.z() + 1.5 * std::sin(0.6 * p.x()));
}

}  // namespace fulcrum::content
