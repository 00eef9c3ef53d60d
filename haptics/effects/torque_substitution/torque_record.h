#pragma once
// Torque substitution, as the trace, the panel and the renderer see it.

#include "haptics/signal/quantity.h"

namespace fulcrum {

// What one tick leaves behind.
struct TorqueRecord {
  bool bad = false;
  double magnitude = 0;       // N m, of the torque that full stiffness gives
  double stiffness = 0;       // N m/rad, the coupling's torque over its angle
  double vibration = 0;       // N, amplitude of the tone
  double ghost = 0;           // opacity, 0 to 1
  double vibration_gain = 0;  // 0: switched off
  double ghost_gain = 0;      // 0: switched off
  double energy = 0;          // J, that the vibration has given to the hand
};

template <class V>
void describe(V& values, const TorqueRecord& record) {
  const auto& [bad, magnitude, stiffness, vibration, ghost, vibration_gain, ghost_gain, energy] = record;
  values.count(
      {"torque_substitution/bad", "1", "", "1 while no force that the hand feels can tell of the torque."},
      bad);
  values.number({"torque_substitution/magnitude", "N m", "",
                 "Of the torque that the coupling's full stiffness gives, about T."},
                magnitude);
  values.number({"torque_substitution/stiffness", "N m/rad", "",
                 "The coupling's torque over the angle between hand and tool."},
                stiffness);
  values.number(
      {"torque_substitution/vibration", "N", "", "Amplitude of the vibration that tells of torque."},
      vibration);
  values.number({"torque_substitution/ghost", "1", "", "Opacity of the ghost, 0 to 1."}, ghost);
  values.number({"torque_substitution/vibration_gain", "1", "", "What the vibration is set to; 0: off."},
                vibration_gain);
  values.number({"torque_substitution/ghost_gain", "1", "", "What the ghost is set to; 0: off."}, ghost_gain);
  values.number(
      {"torque_substitution/energy", "J", "", "What the vibration has given to the hand since the start."},
      energy);
}

}  // namespace fulcrum
