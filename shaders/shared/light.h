// The lights that models bring: points, and light from infinitely far away, none of which throw shadows.
#ifndef FULCRUM_SHADERS_SHARED_LIGHT_H
#define FULCRUM_SHADERS_SHARED_LIGHT_H

#include "types.h"

#define FULCRUM_MOST_LIGHTS 8

FULCRUM_GPU_BEGIN

struct LightData {
  vec4 position;   // xyz in the world (m), w 1 for one that has a place, 0 for a directional one
  vec4 direction;  // xyz unit, as the light travels
  vec4 colour;     // rgb times intensity, irradiance / pi; of one that has a place at 1 m
  vec4 fade;  // xy what the cosine to a spot's axis is multiplied by and what is added, z 1 / range^2 (1/m^2);
              // 0, 1 and 0 where it does not fade
};

struct LightsData {
  LightData each[FULCRUM_MOST_LIGHTS];
};

FULCRUM_GPU_SIZE(LightsData, 4 * FULCRUM_MOST_LIGHTS * 16);

FULCRUM_GPU_END

#endif
