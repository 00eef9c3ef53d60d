#pragma once
// Two models for who has none yet: a board with a step on it, and a pin to touch it with.

#include "engine/assets/model.h"

namespace fulcrum::app {

Model starter_board();  // 160 x 20 x 120 mm below y = 0, a step of 50 x 15 x 50 mm on it
Model starter_pin();    // along y: its tip at y = 0, 110 mm long, 10 mm thick

}  // namespace fulcrum::app
