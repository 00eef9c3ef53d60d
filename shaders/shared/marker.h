// One glowing sphere.
#ifndef FULCRUM_SHADERS_SHARED_MARKER_H
#define FULCRUM_SHADERS_SHARED_MARKER_H

#include "types.h"

FULCRUM_GPU_BEGIN

struct MarkerData {
  vec4 sphere;  // xyz centre in the world, w radius (m)
  vec4 state;   // x kind (MARKER_...), y progress of the dwell 0..1
  vec4 tint;    // rgb linear
};

FULCRUM_GPU_SIZE(MarkerData, 3 * 16);

FULCRUM_GPU_END

// MarkerData.state.x; numbers for both languages. Hidden ones are not sent.
#define FULCRUM_MARKER_NEXT 0
#define FULCRUM_MARKER_DWELLING 1
#define FULCRUM_MARKER_DONE 2

#endif
