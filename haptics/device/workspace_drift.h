#pragma once
// Workspace drift: while the hand moves, the place that stands for the workspace's middle creeps after it, so
// slowly that it is not noticed. Eyes keep the tool where it is meant to be, and so the hand comes back
// towards the middle. F. Conti, O. Khatib, "Spanning large workspaces using small haptic devices", World
// Haptics 2005.
//
// Per tick, in D:     shift = drift |dp| r,     r = p / workspace for each axis, no longer than 1
// p is the handle's place, dp its way in the tick. No farther than that part of its way, not at all while it
// rests, and the less the nearer it is to the middle: a hand that keeps its tool on a path of the length L,
// in a workspace of the half extent e, comes back as exp(-drift L / (position_scale e)).
//
// A way counts once it is longer than 1.5 encoder steps, since a count may toggle while the handle rests. One
// that is longer than a hand goes in a tick (20 mm, kFarthestWay in haptics/world/handle_input.cpp) does not
// count: it is a device's error.

#include "haptics/math/clamp_norm.h"
#include "haptics/math/linear.h"

namespace fulcrum {

// (3) m in D, that the scene is shifted by against the device: the tool goes on by it. p_D (3) m, the
// handle's place from the workspace's middle, dp_D (3) m. workspace (3) m, half extents; an axis of less
// than kLeastExtent does not drift.
inline constexpr double kLeastExtent = 1e-6;  // m
inline Vec3 workspace_drift(double drift, const Vec3& p_D, const Vec3& dp_D, const Vec3& workspace) noexcept {
  const Vec3 r = (workspace.array() >= kLeastExtent).select(p_D.cwiseQuotient(workspace), Vec3::Zero());
  return drift * dp_D.norm() * clamp_norm(r, 1);
}

}  // namespace fulcrum
