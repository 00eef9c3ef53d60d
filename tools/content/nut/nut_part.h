#pragma once

#include "tools/content/mesh/model.h"

namespace fulcrum::content {

// The nut in hand. T: its middle, z along its axis.
Model make_nut();

// The bolt that it goes on, in W.
Solid bare_bolt();

// m, along z: how far the nut's thread, turned by `angle` (rad), is above being in step with the bolt's where
// its middle is at z. In step its axial play is half up.
double out_of_step(double z, double angle);

}  // namespace fulcrum::content
