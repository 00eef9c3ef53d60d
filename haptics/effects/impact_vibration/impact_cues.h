#pragma once
// The vibration at impacts, as the trace, the panel and the renderer see them.

#include <cstdint>

#include "haptics/math/wrench.h"

namespace fulcrum {

// What the vibration leaves behind in one tick.
struct ImpactCues {
  double gain = 0;             // 0: switched off
  std::int32_t voices = 0;     // that sound
  std::int64_t dropped = 0;    // voices, since the start
  double frequency_Hz = 0;     // of the newest voice, its first mode; 0: there was none yet
  double radius = 0;           // m, likewise, from the handle to the impact
  Vec3 axis_W = Vec3::Zero();  // (3) unit, likewise: about which it turns; zero where it pushes alone
  Wrench amplitude_D;          // likewise, on the handle, at gain 1
  Wrench F_H_D;                // what was commanded on the handle in this tick, about H
  double energy = 0;           // J, that the vibration has given to the hand
};

}  // namespace fulcrum
