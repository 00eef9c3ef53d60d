#pragma once
// How far beyond a free path a shell point may go in one motion.

#include "haptics/geometry/distance_field.h"

namespace fulcrum {

// m. A part of the thinnest wall, so that a point which enters one is pushed back out on the side that it
// came from.
double motion_allowance(const DistanceField& field);

}  // namespace fulcrum
