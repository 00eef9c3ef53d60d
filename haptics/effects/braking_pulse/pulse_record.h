#pragma once
// A braking pulse, as the trace, the panel and the renderer see it.

#include "haptics/math/wrench.h"
#include "haptics/signal/quantity.h"

namespace fulcrum {

// What one tick leaves behind.
struct PulseRecord {
  double gain = 0;           // 0: switched off
  bool moment = false;       // a moment may make up for missing force
  Wrench wanted_F_H_D;       // that would stop the hand, about H
  Wrench F_H_D;              // what was commanded of it
  double force_share = 0;    // gamma: of the wanted force; 0 where none was wanted
  double moment_share = 0;   // mu: of the moment that the hand would feel by the whole force
  double energy = 0;         // J, that its force has given to the hand; below 0: taken
  double moment_energy = 0;  // J, that its torque has
};

template <class V>
void describe(V& values, const PulseRecord& record) {
  const auto& [gain, moment, wanted_F_H_D, F_H_D, force_share, moment_share, energy, moment_energy] = record;
  values.number({"braking_pulse/gain", "1", "", "What the braking pulse is set to; 0: off."}, gain);
  values.count({"braking_pulse/moment", "1", "", "1 while a moment may compensate for missing force."},
               moment);
  values.wrench({"braking_pulse/wanted", "", "D", "That would stop the hand, on the handle, about H"},
                wanted_F_H_D);
  values.wrench({"braking_pulse", "", "D", "Commanded of it"}, F_H_D);
  values.number({"braking_pulse/force_share", "1", "", "Of the wanted force, gamma; 0: none was wanted."},
                force_share);
  values.number(
      {"braking_pulse/moment_share", "1", "", "Of the moment that the hand would feel by the whole force."},
      moment_share);
  values.number({"braking_pulse/energy", "J", "",
                 "What the force of braking pulses has given to the hand; below zero: taken."},
                energy);
  values.number({"braking_pulse/moment_energy", "J", "",
                 "What the torque of braking pulses has given to the hand; below zero: taken."},
                moment_energy);
}

}  // namespace fulcrum
