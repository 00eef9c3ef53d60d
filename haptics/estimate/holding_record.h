#pragma once
// Where the hand holds the stick, as the trace, the panel and the renderer see it.

#include "haptics/device/holding_strip.h"
#include "haptics/estimate/holding_point.h"
#include "haptics/signal/quantity.h"

namespace fulcrum {

// What one tick leaves behind.
struct HoldingRecord {
  double place = 0;          // m, along the stick from the handle's origin; what is used
  Vec3 p_HG = Vec3::Zero();  // (3) m, the same as a point of the handle
  HoldingState state = HoldingState::set;
  double strip_ohm = kNoStrip;  // as read; infinity: open; NaN: no strip
  double limit = 0;  // N/m, the stiffest wall that the device's structure renders where the tool touches;
                     // 0: nothing touches, or its structure is not known
};

template <class V>
void describe(V& values, const HoldingRecord& record) {
  const auto& [place, p_HG, state, strip_ohm, limit] = record;
  values.number(
      {"holding_point/place", "m", "", "Where the hand holds the stick, along it from the handle's origin."},
      place);
  values.unseen(p_HG);
  values.count({"holding_point/state", "1", "",
                "Where that comes from: 0 set, 1 measured, 2 the last that was trusted, 3 on its way to the "
                "scenario's, 4 the scenario's for want of any other."},
               static_cast<std::int64_t>(state));
  values.number({"holding_point/strip_ohm", "ohm", "",
                 "Of the strip under the hand; inf: nothing presses on it, nan: there is none."},
                strip_ohm);
  values.number({"holding_point/limit", "N/m", "",
                 "The stiffest wall that the device's structure renders where the tool touches; 0: nothing "
                 "touches, or how stiff the device is, is not known."},
                limit);
}

}  // namespace fulcrum
