#pragma once
// Whether the ear is what it should be: a canal that the needle passes only if it is rolled.

#include "tools/content/ear/route.h"
#include "tools/content/mesh/triangle_tree.h"

namespace fulcrum::content {

// No fixed roll passes: at the best of them the needle's room is negative somewhere.
bool check_rolls(const Passage& passage);

// The clearance of the needle's points on the expert's way; `scene` holds the ear's triangles, in metres.
bool check_way(const std::vector<RoutePose>& route, const TriangleTree& scene, const Model& needle);

// The canal's length and widths.
bool check_canal(const Canal& canal);

}  // namespace fulcrum::content
