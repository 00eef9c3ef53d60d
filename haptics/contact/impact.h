#pragma once
// An impact: the tool has met the scene where it did not touch it before.

#include <cstdint>

#include "haptics/math/linear.h"

namespace fulcrum {

struct Impact {
  Vec3 p_W = Vec3::Zero();     // (3) m, centre of the region that was met
  Vec3 nhat_W = Vec3::Zero();  // (3) unit, out of the scene, towards the tool
  double speed = 0;            // m/s, > 0, of the hand towards the scene there
  std::int32_t object = 0;     // what was met, see geometry/object_map.h; 0 in a scene of one object
};

// The impacts of one tick.
struct ImpactTick {
  std::int32_t count = 0;
  Impact hardest;  // speed 0: there was none
};

}  // namespace fulcrum
