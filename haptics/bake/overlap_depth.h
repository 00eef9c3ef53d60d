#pragma once
// How deep two solids lie in each other, over the whole of both surfaces: corners, edges and faces.
//
// A point of one surface is as deep as it is far from the surface of the component of the other solid that
// holds it; the depth of the overlap is that of the deepest point, whichever surface it lies on. Only
// triangles that cross a surface of the other solid, or lie behind one, have such points: crossing pairs are
// found by boxes, what lies behind by walking from neighbour to neighbour. A piece of such a triangle has a
// bound: the depth is 1-Lipschitz, and it is at most the distance to any one triangle of the other surface,
// which, a triangle being convex, is largest at a corner of the piece. The piece with the largest bound is
// cut, along the walls over its nearest triangle or in halves, until no bound is above what was found.
//
// Of solids that lie clear of each other it is told by how much, at least: from the distances of the centres
// of the tool's boxes and triangles, less their radii; what that leaves open is cut further.

#include <cstdint>
#include <limits>

#include "haptics/bake/triangle_distance.h"
#include "haptics/geometry/distance_field.h"
#include "haptics/math/pose.h"

namespace fulcrum {

struct DeepestOverlap {
  double depth = 0;         // m, of the deepest point found; 0: none was deeper than asked for
  double bound = 0;         // m, no point of either surface is deeper
  double clearance = 0;     // m, the surfaces are no nearer to each other; 0: they overlap, or it is unknown
  Vec3 p_W = Vec3::Zero();  // (3) m, the deepest point found; without meaning at depth 0
  std::int64_t distances = 0;  // distances to a solid that were computed: what the answer cost
};

class OverlapDepth {
public:
  struct Limits {
    double above = 0;         // m, nothing that is less deep is looked for
    double tolerance = 1e-6;  // m, between depth and bound
    std::int64_t distances = std::numeric_limits<std::int64_t>::max();  // where the search stops, short of it
  };

  // field: of scene_W, or none; with one, what of the tool is clear of the scene is left out sooner. All
  // three must outlive this.
  OverlapDepth(const Solid& scene_W, const Solid& tool_T, const DistanceField* field);

  // The bound holds whatever the limits; where `above` is larger than it the depth is 0.
  DeepestOverlap at(const Pose& X_WT, const Limits& limits) const;

  // From T's origin to the tool's farthest vertex, m.
  double reach() const { return reach_; }

private:
  // Both count the distances that they compute, and none that a field tells.
  double clearance(const Pose& X_WT, std::int64_t& distances) const;
  // The scene's surface does not come into the ball. Where there is a field it is outside, too.
  bool is_clear(const Vec3& p_W, double radius, std::int64_t& distances) const;

  const Solid& scene_W_;
  const Solid& tool_T_;
  const DistanceField* field_;
  TriangleDistance to_scene_, to_tool_;
  double reach_ = 0;
};

}  // namespace fulcrum
