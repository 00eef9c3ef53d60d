#pragma once
// The sides of a tooth: what one sees of it from mesial, distal, buccal and lingual.

#include <vector>

#include <Eigen/Geometry>

#include "tools/content/mesh/profile.h"

namespace fulcrum::content {

// A groove or a hollow that runs up a side: as deep as `depth` at x, fading out at both ends.
struct SideGroove {
  double x = 0.0;      // mm, mesial positive
  double lean = 0.0;   // of x for each mm upwards
  double width = 0.5;  // mm
  double depth = 0.2;  // mm; negative: a ridge
  double from = 0.0;   // mm, height where it begins
  double to = 0.0;     // mm, height where it is as deep as it gets
};

// In the tooth's coordinates, mm: x mesial, y buccal (labial), z occlusal (incisal), 0 at the cervical line.
struct CrownBody {
  Profile mesial, distal, buccal, lingual;  // extents over height
  Profile roundness;   // over height: the exponent of the outline, 2 an ellipse, more a rounded rectangle
  double taper = 0.0;  // of the width from lingual to buccal: positive is wider at the buccal side
  double low = -2.5;   // mm, the root is cut here, hidden in the gum
  std::vector<SideGroove> buccal_grooves{};
  std::vector<SideGroove> lingual_grooves{};

  // About the distance (mm) to the sides; negative inside.
  double distance(const Eigen::Vector3d& p) const;
};

}  // namespace fulcrum::content
