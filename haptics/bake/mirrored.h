#pragma once
// Mirror images (haptics/math/mirror.h) of what is baked, so that a scene for the left hand is felt as the
// image of what was baked for the right one: a bake of the mirrored triangles would put its points elsewhere.

#include "haptics/bake/mass_properties.h"
#include "haptics/bake/solid.h"
#include "haptics/geometry/distance_field.h"
#include "haptics/geometry/pointshell.h"

namespace fulcrum {

// Mirrored twice, each of these is what it was, bit for bit; a field's origin is, to rounding.
TriangleMesh mirrored(TriangleMesh mesh);
Solid mirrored(Solid solid);  // its notes keep the places that they name
MassProperties mirrored(MassProperties of);
Pointshell mirrored(Pointshell shell);

// At M p it says of a place what `field` says at p, to within the rounding of the place in its cell.
DistanceField mirrored(const DistanceField& field);

}  // namespace fulcrum
