#pragma once
// Triangles without height, and corners that lie on the edges of other triangles: what is left where faces
// were tessellated each for itself, and where such seams were closed with triangles of no area.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "haptics/bake/weld.h"

namespace fulcrum {

// m: the shortest of its three heights.
double least_height(const TriangleMesh& mesh, const Triangle& corner);

// Leaves out what is no higher than `height_m`: its edges become open, and its longest one has the third
// corner on it.
Mended drop_slivers(TriangleMesh& mesh, double height_m);

// Cuts each triangle where a vertex of an open edge lies within `width_m` of an open edge of its own, so that
// the two sides have the same edges. Vertices stay where they are.
Mended cut_at_t_junctions(TriangleMesh& mesh, double width_m);

}  // namespace fulcrum
