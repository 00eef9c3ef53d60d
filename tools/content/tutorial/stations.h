#pragma once
// What is touched: a wooden panel with a hoop to go to, a slot to turn for, a pad to touch, ridges to feel
// and a red button to stop at. In W.

#include "tools/content/mesh/model.h"

namespace fulcrum::content {

Model make_stations();

}  // namespace fulcrum::content
