#pragma once
// A braking pulse, as the trace, the panel and the renderer see it.

#include "haptics/math/wrench.h"

namespace fulcrum {

// What one tick leaves behind.
struct PulseCues {
  double gain = 0;           // 0: switched off
  bool moment = false;       // a moment may make up for missing force
  Wrench wanted_F_H_D;       // that would stop the hand, about H
  Wrench F_H_D;              // what was commanded of it
  double force_share = 0;    // gamma: of the wanted force; 0 where none was wanted
  double moment_share = 0;   // of the moment that the hand would feel by the whole force, likewise
  double energy = 0;         // J, that its force has given to the hand; below 0: taken
  double moment_energy = 0;  // J, that its torque has
};

}  // namespace fulcrum
