#include "haptics/effects/torque_substitution/torque_limit.h"

#include <algorithm>

namespace fulcrum {

double TorqueLimit::update(bool bad, double torque, double contact_torque,
                           std::span<const ContactRegion> regions) noexcept {
  if (torque <= limit_) limit_ = kNone;
  if (!bad) return limit_;
  double hardest = 0;
  for (const ContactRegion& region : regions) hardest = std::max(hardest, region.force_W.norm());
  // Before the force is there: a tool that is set in motion by more goes in by its momentum.
  if (hardest > 0) limit_ = std::min(limit_, std::max(least_, contact_torque * largest_force_ / hardest));
  return limit_;
}

}  // namespace fulcrum
