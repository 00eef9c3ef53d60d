#pragma once
// Vibrotactile motion, as the trace, the panel and the renderer see it.

#include <cstdint>

#include "haptics/device/vibrotactile_desc.h"

namespace fulcrum {

struct VibrotactileCues {
  double gain = 0;              // of the levels; 0: switched off
  VibrotactileCommand command;  // what the channels were told
  double missing = 0;           // m/s^2, the most that one of them was asked for beyond what it can
  double x = 0;                 // m, along the axis, from the centre, or from where the window began
  std::int32_t direction = 0;   // of the sweep along the axis: -1, 1; 0: at rest
  double force = 0;             // N, wanted along the axis, before safety
};

}  // namespace fulcrum
