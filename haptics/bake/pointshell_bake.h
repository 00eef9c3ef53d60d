#pragma once
// Solid -> pointshell.

#include <cstdint>
#include <limits>

#include "haptics/bake/solid.h"
#include "haptics/geometry/pointshell.h"
#include "haptics/math/result.h"

namespace fulcrum {

struct PointshellDesc {
  double spacing_m = 1.5e-3;                    // wanted distance between neighbours
  double sharp_angle_rad = 0.5235987755982988;  // 30 degrees: edges that bend more carry points of their own
  // m, how far the surface may stand out from between its points, pressed against a flat wall.
  double deviation = std::numeric_limits<double>::infinity();
  std::uint64_t seed = 1;  // of the sampling; same seed, same shell
};

// Points in the solid's own frame (see transformed()), spaced evenly over the surface, with corners and sharp
// edges kept, and more where the surface bends. Area weights sum to the surface area of all components; the
// covering radius is a proven bound. Refused: spacing that is not positive and finite, a deviation that is
// not positive, or either so fine that the shell would have more than 4 million points.
Result<Pointshell> bake_pointshell(const Solid& solid, const PointshellDesc& desc);

// The scene's convex edges alone, sharper than desc.sharp_angle_rad, to be looked up in a field of the tool:
// points at most spacing_m apart, which stand for no area. Refused: what bake_pointshell refuses, and a solid
// without such edges.
Result<Pointshell> bake_edges(const Solid& solid, const PointshellDesc& desc);

}  // namespace fulcrum
