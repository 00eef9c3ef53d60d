#pragma once
// From a soup with faults to one that is closed: what a modelling program exports becomes what can be baked,
// and whatever had to be guessed is told.

#include <string>
#include <vector>

#include "haptics/geometry/triangle_mesh.h"
#include "haptics/math/result.h"

namespace fulcrum {

// Of the whole area: a smaller sheet that bounds nothing is a scrap, which is left out.
inline constexpr double kScrap = 0.01;
// Of the soup's diagonal: what is less high has no normal, once its corners are rounded to single precision.
inline constexpr double kWithoutHeight = 1e-7;

struct Repaired {
  TriangleMesh mesh;               // as many triangles run along every edge as against it
  std::vector<std::string> notes;  // sentences, with places
};

// In this order: triangles without height are left out, cracks at open edges are closed, edges are cut where
// others have corners on them, triangles that repeat others are left out, the winding is made to agree, walls
// and sheets that part nothing from nothing are left out, holes are filled.
// Refused, with a place and a remedy: a surface with one side, a sheet that bounds nothing, a hole wider than
// a quarter of its body's diagonal.
Result<Repaired> repair_mesh(TriangleMesh welded);

}  // namespace fulcrum
