#pragma once
// How deep a tool's whole surface, not a sampling of it, lies in the swept pipes: by branch and bound over
// its triangles, since the distance is 1-Lipschitz.

#include <vector>

#include "haptics/math/pose.h"
#include "tests/bench/swept_pipes.h"

namespace fulcrum::bench {

class DeepestPoint {
public:
  DeepestPoint(const TriangleMesh& tool_T, std::vector<SweptPipe> pipes);

  // m, positive inside: the depth of the surface's deepest point, at most `tolerance` too small. Where
  // nothing is nearer than kNothing, -kNothing.
  double depth(const Pose& X_WT, double tolerance) const;
  static constexpr double kNothing = 5e-3;  // m

  // Whether some point is deeper than `limit`; one that is so by less than `tolerance` may be overlooked.
  // Faster.
  bool deeper_than(double limit, const Pose& X_WT, double tolerance) const;

private:
  struct Ball {
    Vec3 centre;  // (3) m, in T
    double radius;
  };
  struct Search;

  std::vector<SweptPipe> pipes_;
  std::vector<std::array<Vec3, 3>> triangles_;  // near ones near in memory
  std::vector<std::vector<Ball>> levels_;       // ball i bounds 16 balls of the level before, or 16 triangles
};

}  // namespace fulcrum::bench
