#pragma once
// Learning curves: trials over trials, a page for one participant or for several.

#include <string>
#include <vector>

#include "engine/session/store.h"

namespace fulcrum::session {

// trials: by the time at which they began. Each scenario has its plots of score, time and force.
std::string history_html(const std::vector<StoredTrial>& trials);

}  // namespace fulcrum::session
