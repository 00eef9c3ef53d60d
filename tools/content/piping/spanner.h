#pragma once

#include "tools/content/mesh/model.h"
#include "tools/content/mesh/solid.h"

namespace fulcrum::content {

// A ring at one end of the spanner.
struct RingHead {
  double across_flats;  // m, of the nut it fits
  double radius;        // m, outside
  double height;        // m, along its axis
  double rounding;      // m, of the outer edges
};

// A double-ended ring spanner in its drawing frame: long axis x, ring axes z, the rings' middle plane z = 0,
// the shank raised by the offset. After DIN 838 in proportion.
struct SpannerDesign {
  static constexpr RingHead large{19 * mm, 14.5 * mm, 12 * mm, 1.4 * mm};
  static constexpr RingHead small{17 * mm, 13.4 * mm, 11 * mm, 1.2 * mm};
  static constexpr double half_length = 81.25 * mm;  // from the middle to the axis of each ring
  static constexpr double offset = 7.0 * mm;
  static constexpr double shank_half_width = 6.8 * mm;
  static constexpr double shank_half_thickness = 3.9 * mm;
  static constexpr double crank_start = 14.0 * mm;  // from the ring's axis
  static constexpr double crank_end = 41.0 * mm;
};

// Height of the neck's or shank's middle above the rings' middle plane, at a distance from a ring's axis.
double crank_height(double from_ring_axis);

// The spanner in its drawing frame: one solid with two holes.
Solid spanner_solid();

// Where the centre of mass lies in the drawing frame: (3) m.
Eigen::Vector3d spanner_centre_of_mass();

// The spanner with its origin at its centre of mass.
Model make_spanner();

}  // namespace fulcrum::content
