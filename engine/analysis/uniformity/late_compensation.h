#pragma once
// A hand that holds a stick on a ball while m a comes late: what the theory says, and what the tick makes of
// it.

#include <vector>

#include "engine/analysis/uniformity/inertia_limit.h"
#include "engine/analysis/uniformity/stick_scene.h"

namespace fulcrum::analysis::uniformity {

struct LateRun {
  double jerk = 0, lag = 0;  // m/s^3 per root Hz and s, of the filter
  double growth = 0;         // 1/s, of the linear loop, exactly; above 0 it shakes
  double swing = 0,
         swing_unfaded = 0;  // m, from lowest to highest in the last half second; with fading and without
  double faded_at = -1;      // s, when the gain began to fade; below 0: never
  double least_port = 0;     // J, of the passivity observer
  std::vector<double> way, way_unfaded;  // (ticks) m, height of the handle
};

// The filter at each of `jerks`, in a hand of the loop's figures; the device is taken without friction, as
// the loop is.
std::vector<LateRun> study_late_compensation(const StickBodies& bodies, const DeviceDesc& device,
                                             const InertiaLoop& loop, const std::vector<double>& jerks);

}  // namespace fulcrum::analysis::uniformity
