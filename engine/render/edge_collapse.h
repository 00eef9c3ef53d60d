#pragma once
// Fewer and fewer triangles for the same surface.

#include <array>
#include <cstdint>
#include <vector>

#include "engine/render/quadric.h"
#include "engine/render/slide_quadric.h"

namespace fulcrum::render {

using Corners = std::array<std::uint32_t, 3>;

struct Patch {
  std::vector<glm::dvec3> positions;  // (n) m
  std::vector<SeenAt> seen;           // (n) in units of a large difference
  std::vector<UvAt> uv;               // (n) m, as SlideQuadric has it; or none
  std::vector<bool> stays;            // (n) another patch has it, too
  std::vector<Corners> triangles;     // into these
};

struct CoarserPatch {
  std::vector<Corners> triangles;
  double error = 0.0;  // m, see LevelsOfDetail::Level
};

// Each has about half the triangles of the one before. Vertices at a seam, where two of them with other
// normals, colours or places in textures lie at one place, go along it, both at once. Those that stay, at
// a rim, where seams end or meet, or where more than two triangles share an edge stay: the last is as coarse
// as these allow.
std::vector<CoarserPatch> collapse_edges(Patch patch);

}  // namespace fulcrum::render
