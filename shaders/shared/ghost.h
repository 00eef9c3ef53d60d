// The ghost: lines of the tool where the hand has turned to.
#ifndef FULCRUM_SHADERS_SHARED_GHOST_H
#define FULCRUM_SHADERS_SHARED_GHOST_H

#include "types.h"

FULCRUM_GPU_BEGIN

struct GhostLine {
  vec4 from;  // xyz in the ghost's frame (m)
  vec4 to;
};

FULCRUM_GPU_SIZE(GhostLine, 2 * 16);

struct GhostDraw {       // push constants
  mat4 clip_from_ghost;  // reversed depth, as the scene's
  vec4 size;             // xy of the picture (pixels), zw of the scene's targets in relation to it
  vec4 width;            // x half the width of a line, y how far its halo reaches beyond (pixels)
  vec4 colour;           // rgb sRGB encoded, a opacity
};

FULCRUM_GPU_SIZE(GhostDraw, 64 + 3 * 16);

FULCRUM_GPU_END

#endif
