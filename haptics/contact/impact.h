#pragma once
// An impact: the tool has met the scene where it did not touch it before.

#include <cstdint>

#include "haptics/math/linear.h"
#include "haptics/signal/quantity.h"

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

template <class V>
void describe(V& values, const ImpactTick& record) {
  const auto& [count, hardest] = record;
  const auto& [p_W, nhat_W, speed, object] = hardest;
  values.count({"impact/count", "1", "", "Impacts in this tick."}, count);
  values.number(
      {"impact/speed", "m/s", "", "Of the hand towards the scene at the hardest of them; 0: there was none."},
      speed);
  values.count({"impact/object", "1", "",
                "Which of the scene's models it struck, from 0; -1: there was none. Always 0 where nothing "
                "asks which."},
               count > 0 ? object : -1);
  values.vector({"impact/p", "m", "W", "Where it was; zero: there was none."}, p_W);
  values.vector({"impact/normal", "1", "W", "The scene's normal there, towards the tool."}, nhat_W);
}

}  // namespace fulcrum
