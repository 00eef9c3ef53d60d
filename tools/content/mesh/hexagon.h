#pragma once
// Sections of hexagon heads and nuts, about the z axis; a corner of the hexagon is on the x axis.

#include "tools/content/mesh/loft.h"

namespace fulcrum::content {

Section circle(double radius, double z, int columns);
Section hexagon(double across_flats, double z, int columns);

// The edge where a hexagon meets the cone that chamfers its end at z. `outward` is the sign of the end's
// direction along z.
Section chamfered_hexagon(double across_flats, double z, double outward, int columns);

// Of the flat that the chamfer leaves at a hexagon's end (m).
inline double flat_radius(double across_flats) {
  return 0.475 * across_flats;
}

}  // namespace fulcrum::content
