#pragma once
// From closed triangles to the components of a solid: which surface bounds what.

#include "haptics/bake/solid.h"

namespace fulcrum {

// `closed`: welded, as many triangles along every edge as against it. One component for each connected
// surface, its triangles together and its volume measured, which may be negative; each fan of triangles about
// a vertex gets a vertex of its own.
Solid part_surfaces(const TriangleMesh& closed, const std::vector<std::uint32_t>& across);

// Components that are named together become one, with the box of the first; what is not named goes.
void regroup(Solid& solid, const std::vector<std::vector<std::uint32_t>>& groups);

// A component's triangles with vertices of their own.
TriangleMesh own_triangles(const TriangleMesh& mesh, const SolidComponent& component);

// By the divergence theorem, over the component's triangles.
void measure_volume(const TriangleMesh& mesh, SolidComponent& component);

// A surface inside out joins, as a cavity, the smallest component that holds all of it; where there is none
// it is turned and noted.
void assign_cavities(Solid& solid);

// Components that cross themselves are cut back to what bounds them and get a shell; so get those with
// slivers.
void cut_self_crossings(Solid& solid);

}  // namespace fulcrum
