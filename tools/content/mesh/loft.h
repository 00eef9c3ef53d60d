#pragma once

#include <span>
#include <vector>

#include "tools/content/mesh/solid.h"

namespace fulcrum::content {

// Corners around one cross-section; every section of a loft has as many.
using Section = std::vector<Eigen::Vector3d>;

enum class Cap {
  fan,    // about the section's mean point: for sections that are star-shaped about it
  strip,  // between the first half of the section and the second half, walked backwards: for channels
};

// The solid through a stack of sections, closed at both ends.
Solid loft(std::span<const Section> sections, Cap cap = Cap::fan);

// The solid through sections of which the last joins the first: the rims of hand-wheels.
Solid closed_loft(std::span<const Section> sections);

struct RadiusHeight {
  double r = 0.0;  // m
  double z = 0.0;  // m
};

// A profile turned about the z axis, closed by flat discs at its first and last point.
Solid lathe(std::span<const RadiusHeight> profile, int columns);

// A closed profile that stays off the axis, turned about z.
Solid lathe_ring(std::span<const RadiusHeight> profile, int columns);

// A box from -half to +half with every edge chamfered, so that it catches light.
Solid chamfered_box(const Eigen::Vector3d& half, double chamfer);

}  // namespace fulcrum::content
