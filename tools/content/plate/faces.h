#pragma once
// What is struck: four steel plates side by side around a quarter of a circle, level, tilted and upright, so
// that a tip that comes straight down or from the right meets one of them at any angle.

#include <array>

#include "tools/content/mesh/prism.h"

namespace fulcrum::content {

inline constexpr std::size_t face_count = 4;
inline constexpr double face_half_depth = 30.0 * mm;  // along z
inline constexpr double plate_thickness = 8.0 * mm;

struct Face {
  double tilt = 0.0;         // rad, from level, towards -x
  double width = 0.0;        // m, across z
  Eigen::Vector3d centre_W;  // m
  Eigen::Vector3d nhat_W;    // unit, outwards

  // Unit, along the face and across z, to the right.
  Eigen::Vector3d along_W() const { return nhat_W.cross(Eigen::Vector3d::UnitZ()); }
};

// The middle of the level face is the origin of W.
std::array<Face, face_count> faces();

// The faces are drawn in a plane in which they turn to the right; W sees it from behind.
Eigen::Isometry3d drawing_in_world();

// In the drawing: the corners of the chain of faces, moved inwards by `depth` (m): one more than there are
// faces.
std::array<Eigen::Vector2d, face_count + 1> chain(double depth);

}  // namespace fulcrum::content
