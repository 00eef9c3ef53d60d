#pragma once
// A coarser model to draw, by meshoptimizer: M. Garland and P. Heckbert, "Surface simplification using
// quadric error metrics" (SIGGRAPH 1997).

#include "engine/assets/model.h"

namespace fulcrum::importing {

// As few triangles as keep every part within about `tolerance` (m) of what it was: the error that is held is
// the quadrics' estimate, of each part by itself. Corners stay where they were; none is made.
Model simplified(const Model& model, double tolerance);

}  // namespace fulcrum::importing
