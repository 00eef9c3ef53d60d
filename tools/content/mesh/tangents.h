#pragma once

#include <Eigen/Core>
#include <vector>

#include "tools/content/mesh/shading.h"

namespace fulcrum::content {

// Of each vertex, as glTF has them for relief: xyz unit, square to the normal, the way along which u grows; w
// is -1 where the picture lies mirrored on the surface, 1 elsewhere. The mean of the triangles round it.
std::vector<Eigen::Vector4f> tangents(const ShadedMesh& mesh, const std::vector<Eigen::Vector2f>& uv);

}  // namespace fulcrum::content
