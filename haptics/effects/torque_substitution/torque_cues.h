#pragma once
// Torque substitution, as the trace, the panel and the renderer see it.

namespace fulcrum {

// What one tick leaves behind.
struct TorqueCues {
  bool bad = false;
  double magnitude = 0;       // N m, of the torque that full stiffness gives
  double stiffness = 0;       // N m/rad, the coupling's torque over its angle
  double vibration = 0;       // N, amplitude of the tone
  double ghost = 0;           // opacity, 0 to 1
  double vibration_gain = 0;  // 0: switched off
  double ghost_gain = 0;      // likewise
  double energy = 0;          // J, that the vibration has given to the hand
};

}  // namespace fulcrum
