#pragma once
// Where the hand holds the stick, as the trace, the panel and the renderer see it.

#include "haptics/device/holding_strip.h"
#include "haptics/estimate/holding_point.h"

namespace fulcrum {

// What one tick leaves behind.
struct HoldingCues {
  double place = 0;          // m, along the stick from the handle's origin; what is used
  Vec3 p_HG = Vec3::Zero();  // (3) m, the same as a point of the handle
  HoldingState state = HoldingState::set;
  double strip_ohm = kNoStrip;  // as read; infinity: open; NaN: no strip
  double limit = 0;  // N/m, the stiffest wall that the device's structure renders where the tool touches;
                     // 0: nothing touches, or its structure is not known
};

}  // namespace fulcrum
