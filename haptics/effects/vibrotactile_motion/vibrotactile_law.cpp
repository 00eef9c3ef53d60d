#include "haptics/effects/vibrotactile_motion/vibrotactile_law.h"

#include <cmath>

#include "haptics/math/functions.h"

namespace fulcrum {

double motion_envelope(const MotionLaw& law, double x, double window) noexcept {
  if (law.envelope == MotionEnvelope::linear) return x / window;
  return math::log1p(x / law.reference) / math::log1p(window / law.reference);
}

double trailing_onset(const MotionLaw& law, double speed) noexcept {
  if (law.onset == MotionOnset::together) return 0;
  const double onset = kSoaPart * law.window + kSoaBase * std::abs(speed);  // SOA v
  return onset < law.window ? onset : 0.0;
}

MotionLevels motion_levels(const MotionLaw& law, double x, double onset) noexcept {
  if (!(x >= 0 && x <= law.window)) return {};
  return {.leading = motion_envelope(law, law.window - x, law.window),
          .trailing = x > onset ? motion_envelope(law, x - onset, law.window - onset) : 0.0};
}

}  // namespace fulcrum
