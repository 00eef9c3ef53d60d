#pragma once
// A body that the models' programs build, as contact takes it.

#include <utility>

#include "haptics/geometry/triangle_mesh.h"
#include "tools/content/mesh/solid.h"

namespace fulcrum::parts {

inline TriangleMesh mesh_of(content::Solid solid) {
  return {std::move(solid.points), std::move(solid.triangles)};
}

}  // namespace fulcrum::parts
