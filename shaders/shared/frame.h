// What every shader may know about a frame. World space, metres; colours linear.
#ifndef FULCRUM_SHADERS_SHARED_FRAME_H
#define FULCRUM_SHADERS_SHARED_FRAME_H

#include "types.h"

FULCRUM_GPU_BEGIN

struct FrameData {
  mat4 clip_from_world;    // reversed depth: 1 at the near plane, 0 infinitely far
  mat4 shadow_from_world;  // clip space of the shadow map: depth 0 near the light, 1 far
  vec4 eye;                // xyz position, w simulated time in s, wrapped to an hour
  vec4 camera_right;       // xyz unit
  vec4 camera_up;  // xyz unit, w how far what is drawn may be off the surface it stands for, at 1 m (m)
  vec4 key_position;       // xyz position, w 1; of a directional light the way to it, unit, w 0
  vec4 key_direction;      // xyz unit, as the light travels; w cosine of the half angle where it ends
  vec4 key_colour;  // rgb times intensity and the square of the way from its rim to 1 m before it; w cosine
                    // of the half angle where it begins to fade; a directional one's are below -1
  vec4 around_linear[3];  // irradiance / pi from all around (engine/render/environment.h); red, green, blue
  vec4 around_quadratic[3];
  vec4 around_rest;        // rgb
  vec4 background_top;     // rgb
  vec4 background_bottom;  // rgb
  vec4 volume_from_world;  // xyz what a place is multiplied by, w how far before a surface the volume is read
                           // (m)
  vec4 volume_low;         // xyz added to that, w 4 / its longest side (1/m); engine/render/light_volume.h
  vec4 unhidden;  // irradiance / pi (luminance) facing d, where nothing hides anything: dot(xyz, d) + w
  vec4 mirror_from_world;  // xyz what a place is multiplied by, w edge of a voxel (m);
                           // engine/render/mirror_volume.h
  vec4 mirror_low;         // xyz added to that, w its coarsest level
  vec4 lens;               // xy tangents of half the picture's width and height, zw where its middle leans to
  vec4 occlusion;          // xy size of the image (pixels), z distance of depth 1 (m)
  vec4 shadow;             // x 1/size of the map, y texel and z spread of engine/render/light_fit.h, w half the
                           // light's diameter (m)
};

FULCRUM_GPU_SIZE(FrameData, 2 * 64 + 23 * 16);

FULCRUM_GPU_END

#endif
