#pragma once
// The wall loop without friction and encoder counts, solved exactly.
//
// Zero-order hold of the mass and damper, x and v a tick on; the way of the last tick and u_before for the
// velocity; each whole tick of delay one force that waits. K. J. Astrom, B. Wittenmark, "Computer-Controlled
// Systems", Prentice Hall 1997, chapter 3.
//
// The wall may be a tool with a mass, which nothing else holds: x is then counted from the tool, and the
// tool's velocity is one more state. The hold makes the same energy on a swing that the device's damping sees
// only a part of, m_tool / (m + m_tool): without damping in the coupling such a loop holds 1 + m / m_tool
// times less.

#include <optional>

#include "haptics/device/wall_loop.h"
#include "haptics/tool/rigid_body.h"

namespace fulcrum {

struct FreeTool {
  double mass = 0.1;  // kg, as the device feels it
  Integrator integrator = Integrator::semi_implicit_euler;
};

// 1/s, of the swing that grows most or decays least, ln |z| / T over the loop's eigenvalues z; below 0 the
// loop is stable. With a free tool on a device without damping, that both fly on together is a z of 1.
double exact_growth(const WallLoop& loop, const Wall& wall, const std::optional<FreeTool>& tool = {});

// N/m, the stiffness up to which the loop is stable with this damping; 0 where it is at none.
double exact_stiffness_limit(const WallLoop& loop, double B);

// N s/m, the wall's damping above which no stiffness is stable.
double exact_damping_limit(const WallLoop& loop);

}  // namespace fulcrum
