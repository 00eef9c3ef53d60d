#pragma once
// What theory promises of a wall in any hand that is passive itself.

#include "haptics/device/wall_loop.h"

namespace fulcrum::analysis::stability {

// N/m, the largest stiffness of a wall that gives out no energy at any frequency, 0 where the damping alone
// does. J. E. Colgate, G. G. Schenkel, "Passivity of a class of sampled-data systems: application to haptic
// interfaces", J. Robotic Systems 14(1), 1997, theorem 1, for F = -(K + B (1 - 1/z) / T) x n ticks late:
//     b > K T/2 sin((n + 1/2) wT) / sin(wT/2) - B cos((n + 1) wT)      for all 0 < wT <= pi,
// without delay b > K T/2 + |B|, and without damping b > (n + 1/2) K T.
double passive_stiffness_limit(const WallLoop& loop, double B);

// J, what a spring K that is held from tick to tick gives out in a cycle of amplitude A m and w rad/s:
// pi K A^2 sin^2(wT/2) / (wT/2).
double energy_per_cycle(double K, double amplitude, double w, double tick_s);

// N. Diolaiti, G. Niemeyer, F. Barbagli, J. K. Salisbury, "Stability of haptic rendering: discretization,
// quantization, time delay, and Coulomb effects", IEEE Trans. Robotics 22(2), 2006: friction against encoder
// counts, damping against the tick. Their border is the worst case.
struct DiolaitiPlace {
  double beta = 0;   // b / (K T)
  double sigma = 0;  // f_c / (K D); infinite for an exact encoder
};
DiolaitiPlace diolaiti_place(const WallLoop& loop, double K);

enum class DiolaitiRegion {
  settles,          // beta, sigma > 1/2: from any start
  limit_cycle,      // beta > 1/2 > sigma: trembles, by some encoder counts
  settles_if_slow,  // sigma > 1/2 > beta: friction holds what is slow; what is fast grows
  grows             // both below 1/2
};
DiolaitiRegion diolaiti_region(const DiolaitiPlace& place);

}  // namespace fulcrum::analysis::stability
