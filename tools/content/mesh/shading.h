#pragma once

#include <cstdint>
#include <vector>

#include "tools/content/mesh/solid.h"
#include "tools/content/mesh/unwrap.h"

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

// Of each vertex, from where its corners lie. Vertices that lie at several places are repeated, after all the
// others.
std::vector<Eigen::Vector2f> split_at_seams(ShadedMesh* mesh, const CornerUv& corners);

}  // namespace fulcrum::content
