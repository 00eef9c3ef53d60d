#pragma once
// The vibration at impacts, as the trace, the panel and the renderer see them.

#include <cstdint>

#include "haptics/math/wrench.h"
#include "haptics/signal/quantity.h"

namespace fulcrum {

// What the vibration leaves behind in one tick.
struct ImpactVibrationRecord {
  double gain = 0;             // 0: switched off
  std::int32_t voices = 0;     // that sound
  std::int64_t dropped = 0;    // voices, since the start
  double frequency_Hz = 0;     // of the newest voice, its first mode; 0: there was none yet
  double radius = 0;           // m, of the newest voice: from the handle to the impact
  Vec3 axis_W = Vec3::Zero();  // (3) unit, about which the newest voice turns; zero where it pushes alone
  Wrench amplitude_D;          // of the newest voice, on the handle, at gain 1
  Wrench F_H_D;                // what was commanded on the handle in this tick, about H
  double energy = 0;           // J, that the vibration has given to the hand
};

template <class V>
void describe(V& values, const ImpactVibrationRecord& record) {
  const auto& [gain, voices, dropped, frequency_Hz, radius, axis_W, amplitude_D, F_H_D, energy] = record;
  values.number({"impact_vibration/gain", "1", "", "What the vibration at impacts is set to; 0: off."}, gain);
  values.count({"impact_vibration/voices", "1", "", "Vibrations that sound together."}, voices);
  values.count(
      {"impact_vibration/dropped", "1", "", "Vibrations so far that were dropped for stronger ones."},
      dropped);
  values.number(
      {"impact_vibration/frequency_Hz", "Hz", "", "Of the newest vibration; 0: there was none yet."},
      frequency_Hz);
  values.number({"impact_vibration/radius", "m", "", "From the handle to the impact that it tells of."},
                radius);
  values.vector({"impact_vibration/axis", "1", "W", "About which it turns; zero where it pushes alone."},
                axis_W);
  values.wrench({"impact_vibration/amplitude", "", "D", "Of the newest vibration, at its onset"},
                amplitude_D);
  values.wrench({"impact_vibration", "", "D", "All of them together, as commanded on the handle, about H"},
                F_H_D);
  values.number({"impact_vibration/energy", "J", "",
                 "What the vibration at impacts has given to the hand since the start."},
                energy);
}

}  // namespace fulcrum
