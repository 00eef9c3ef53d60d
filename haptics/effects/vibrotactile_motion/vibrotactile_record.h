#pragma once
// Vibrotactile motion, as the trace, the panel and the renderer see it.

#include <cstdint>

#include "haptics/device/vibrotactile_desc.h"
#include "haptics/signal/quantity.h"

namespace fulcrum {

struct VibrotactileRecord {
  double gain = 0;              // of the levels; 0: switched off
  VibrotactileCommand command;  // what the channels were told
  double shortfall = 0;         // m/s^2, the most that one of them was asked for beyond what it can
  double x = 0;                 // m, along the axis, from the centre, or from where the window began
  std::int32_t direction = 0;   // of the sweep along the axis: -1, 1; 0: at rest
  double force = 0;             // N, wanted along the axis, before safety
};

template <class V>
void describe(V& values, const VibrotactileRecord& record) {
  const auto& [gain, command, shortfall, x, direction, force] = record;
  const auto& [level, glide, stopping] = command;
  values.number({"vibrotactile_motion/gain", "1", "", "What vibrotactile motion is set to; 0: off."}, gain);
  values.each({"vibrotactile_motion/level", "m/s^2", "", "Amplitude that this channel is told to go to."},
              level, values.names().channels);
  values.number({"vibrotactile_motion/shortfall", "m/s^2", "",
                 "The most that a channel was asked for beyond what it can, in amplitude."},
                shortfall);
  values.number({"vibrotactile_motion/glide", "s", "", "In which the channels go to their amplitudes."},
                glide);
  values.unseen(stopping);
  values.number({"vibrotactile_motion/x", "m", "",
                 "Along the axis of the sweep, from its centre; as a fallback, in the window."},
                x);
  values.count(
      {"vibrotactile_motion/direction", "1", "", "Of the sweep along the axis, -1 or 1; 0: at rest."},
      direction);
  values.number(
      {"vibrotactile_motion/force", "N", "", "Wanted along the axis, on the handle, before safety."}, force);
}

}  // namespace fulcrum
