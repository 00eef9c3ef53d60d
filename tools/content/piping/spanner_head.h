#pragma once

#include <cstdint>
#include <vector>

#include "tools/content/mesh/solid.h"
#include "tools/content/piping/spanner.h"

namespace fulcrum::content {

// The opening that a ring leaves for the shank, and every section of the shank, is a frame of points: the
// lower side from -y to +y, the +y side upwards, the upper side back, the -y side downwards.
inline constexpr int frame_across = 24;  // steps along the lower and the upper side
inline constexpr int frame_up = 8;       // steps along each of the other two
inline constexpr int frame_points = 2 * (frame_across + frame_up);

// Half the angle about the ring's axis that the opening takes.
inline constexpr double opening_half_angle = 45.0 * degree;

// Half the opening's height: the outer wall between the roundings.
inline constexpr double opening_half_height(const RingHead& head) {
  return 0.5 * head.height - head.rounding;
}

// Adds a ring with a twelve-point hole to the solid. Its own frame has +x towards the shank; it is placed at
// `centre`, turned half round about z when `turned`. Returns the opening's points, in the order of a frame
// in the drawing's axes.
std::vector<std::uint32_t> add_ring_head(Solid* solid, const RingHead& head, const Eigen::Vector3d& centre,
                                         bool turned);

}  // namespace fulcrum::content
