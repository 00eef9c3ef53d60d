#include "haptics/world/stiffness_levels.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {

void StiffnessLevels::apply(const Command& command) noexcept {
  if (command.kind != Command::Kind::contact_stiffness || !std::isfinite(command.value)) return;
  wanted_ = *std::ranges::min_element(levels_, {},
                                      [&command](double level) { return std::abs(level - command.value); });
}

void StiffnessLevels::set(ToolMotion& motion) noexcept {
  if (now_ != wanted_ && motion.stiffen(wanted_)) now_ = wanted_;
}

}  // namespace fulcrum
