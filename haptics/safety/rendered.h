#pragma once
// What the wants of one tick have come to, for those who wanted.

#include <array>

#include "haptics/safety/transient_budget.h"

namespace fulcrum {

// Wrenches are on the handle about H, in D.
struct Rendered {
  struct Source {
    Wrench F_H_D;             // what was commanded of its transient
    double force_share = 0;   // gamma, of the force that it wanted
    double moment_share = 0;  // of the moment that the hand was to feel
    double energy = 0;        // J, given to the hand since the start, by force and by torque
    double force_energy = 0;
    double torque_energy = 0;
  };
  std::array<Source, kTransientSources> sources{};
  double force_part = 1;   // of the wanted continuous force, what was commanded of it, 0 to 1
  double torque_part = 1;  // the same of the torque

  const Source& of(TransientSource source) const { return sources[static_cast<std::size_t>(source)]; }
};

}  // namespace fulcrum
