#pragma once
// Volume, centre of mass and inertia of a solid of unit density, integrated exactly over its triangles:
// D. Eberly, "Polyhedral mass properties (revisited)", 2002, in the form of signed tetrahedra.

#include "haptics/bake/solid.h"
#include "haptics/math/linear.h"

namespace fulcrum {

struct MassProperties {
  double volume_m3 = 0.0;
  Vec3 centre = Vec3::Zero();   // (3) m
  Mat3 inertia = Mat3::Zero();  // (3 x 3) m^5 about centre: times density, kg m^2
};

// Where components overlap, the overlap counts once for each of them.
MassProperties mass_properties(const Solid& solid);

}  // namespace fulcrum
