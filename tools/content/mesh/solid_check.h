#pragma once

#include <string>

#include "tools/content/mesh/model.h"

namespace fulcrum::content {

// Whether a solid, as it is written (single precision, points welded where they are equal), is closed,
// manifold, facing outwards, free of degenerate triangles and free of self-intersections.
// Empty, or a sentence about the first thing that is wrong.
std::string what_is_wrong(const Solid& solid);

// The same of every part, printed.
bool check_solids(const Model& model);

}  // namespace fulcrum::content
