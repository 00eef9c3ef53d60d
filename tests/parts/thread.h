#pragma once
// Bolts and nuts to ISO 68-1 (profile) with the tolerances 6g and 6H of ISO 965-1, at the middle of their
// fields.

#include "haptics/geometry/triangle_mesh.h"

namespace fulcrum::parts {

struct MetricThread {
  double diameter = 0, pitch = 0;  // m
};

// m, radial: half of what the mean pitch diameters of a 6H nut and a 6g bolt differ by.
double thread_clearance(const MetricThread& thread);

// A threaded rod about z, from z = 0 to length, of `sectors` facets around.
TriangleMesh bolt(const MetricThread& thread, double length, int sectors);
// A hexagon nut about z with its thread, from z = 0 to height, across flats m wide.
TriangleMesh nut(const MetricThread& thread, double height, double across_flats, int sectors);

}  // namespace fulcrum::parts
