// One drawn thing: where it is and what it is made of.
#ifndef FULCRUM_SHADERS_SHARED_INSTANCE_H
#define FULCRUM_SHADERS_SHARED_INSTANCE_H

#include "types.h"

FULCRUM_GPU_BEGIN

struct InstanceData {
  mat4 world_from_mesh;
  vec4 normal_x;  // columns of the inverse transpose of the upper 3 x 3
  vec4 normal_y;
  vec4 normal_z;
  vec4 base_colour;  // rgb linear, a unused
  vec4 surface;      // x metallic, y roughness, z number among those that light spreads below, or 0
};

FULCRUM_GPU_SIZE(InstanceData, 64 + 5 * 16);

FULCRUM_GPU_END

#endif
