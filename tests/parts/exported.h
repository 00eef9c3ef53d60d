#pragma once
// What exporters do to a sound mesh: T-junctions, slivers, faces that do not quite meet, repeats, parts
// inside out, in single precision.

#include <cstdint>

#include "haptics/geometry/triangle_mesh.h"

namespace fulcrum::parts {

// A share of the edges, each cut at up to `most` places on one of its two sides alone; slivers: the other
// side is closed by triangles without height. Positions are rounded to single precision.
TriangleMesh with_t_junctions(const TriangleMesh& mesh, double share, unsigned most, bool slivers,
                              std::uint64_t seed);

// No two triangles share a vertex, and each one's vertices are off by up to `noise` m.
TriangleMesh face_by_face(const TriangleMesh& mesh, double noise, std::uint64_t seed);

// A share of the triangles is there twice.
TriangleMesh repeating(TriangleMesh mesh, double share, std::uint64_t seed);

// All triangles are turned, or a share of them.
TriangleMesh turned(TriangleMesh mesh, double share, std::uint64_t seed);

}  // namespace fulcrum::parts
