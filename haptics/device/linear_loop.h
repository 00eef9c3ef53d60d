#pragma once
// The wall loop without friction and encoder counts, solved exactly.
//
// Zero-order hold of the mass and damper, x and v a tick on; x_before and u_before for the velocity; each
// whole tick of delay one force that waits. K. J. Astrom, B. Wittenmark, "Computer-Controlled Systems",
// Prentice Hall 1997, chapter 3.

#include "haptics/device/wall_loop.h"

namespace fulcrum {

// 1/s, of the swing that grows most or decays least, ln |z| / T over the loop's eigenvalues z; below 0 the
// loop is stable.
double exact_growth(const WallLoop& loop, const Wall& wall);

// N/m, the stiffness up to which the loop is stable with this damping; 0 where it is at none.
double exact_stiffness_limit(const WallLoop& loop, double B);

// N s/m, the wall's damping above which no stiffness is stable.
double exact_damping_limit(const WallLoop& loop);

}  // namespace fulcrum
