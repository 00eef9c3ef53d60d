#pragma once
// The finger that sweeps, with a ring that has a vibrator to either side.

#include "tools/content/mesh/model.h"

namespace fulcrum::content {

// The origin is what touches first: the lowest point of the pad. The finger points away from the trainee.
Model make_finger();

}  // namespace fulcrum::content
