#pragma once

#include <cstdint>
#include <vector>

#include "tools/content/mesh/solid.h"

namespace fulcrum::content {

// What a renderer draws: points are repeated where two smooth surfaces meet at an edge.
struct ShadedMesh {
  std::vector<Eigen::Vector3f> positions;  // (n x 3) m
  std::vector<Eigen::Vector3f> normals;    // (n x 3) unit
  std::vector<Eigen::Vector3f> colours;    // (n x 3) linear, or none
  std::vector<std::uint32_t> indices;      // (3 m)
};

// Smooth normals within surfaces, split where neighbouring triangles turn by more than `crease` (rad).
// `colours`: of the solid's points, or none.
ShadedMesh shade(const Solid& solid, double crease, const std::vector<Eigen::Vector3d>& colours);

}  // namespace fulcrum::content
