#pragma once
// A pointshell's sphere hierarchy against a distance field, by SIMD: the walk behind ContactQuery.
//
// A node is left out when the field at its centre says that no point of it can come within the margin: the
// distance is 1-Lipschitz, and `slack` covers what the stored field errs by: a node no larger than a brick
// needs the slack of its brick alone. Patches of 16 points that remain are looked up whole.
//
// The target (SSE2 to AVX-512) is chosen while running. Every target gives the same bits: single precision
// (double for the middles of patches), products and sums rounded one by one in the order written, square root
// and division as IEEE 754 has them.

#include <array>
#include <cstdint>

#include "haptics/geometry/field_view.h"
#include "haptics/geometry/sphere_tree.h"

namespace fulcrum {

// Sixteen points of which at least one is nearer than the margin.
struct alignas(64) PatchHit {
  std::array<float, kBlock> distance;  // m
  std::uint32_t first;                 // index of the first point
  std::uint32_t touching;              // bit per point: distance < margin
};

struct ShellWalk {
  const SphereTree* tree;
  FieldView field;
  std::array<double, 9> turn;   // (3 x 3) row by row: cells per metre in T
  std::array<double, 3> shift;  // (3) cells
  float margin;                 // m
  float slack;                  // m
  const float* brick_slack;     // (bricks) m, for nodes whose radius is brick_edge at most
  float brick_edge;             // m
  // Called in the order of the shell. Answers with the margin for what follows, at most the present one.
  float (*found)(void* taker, const PatchHit& hit) noexcept;
  void* taker;
};

void walk_shell(const ShellWalk& walk) noexcept;

// Name of the SIMD target that walk_shell() takes.
const char* simd_target();

}  // namespace fulcrum
