// The mean over the sixteen neighbours that occlusion.frag had look sixteen ways, of those that lie on the same surface.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/frame.h"

layout(std140, set = 0, binding = 0) uniform Frame { FrameData frame; };
layout(set = 0, binding = 2) uniform sampler2D rough;

layout(location = 0) in vec2 uv;
layout(location = 0) out vec2 found;  // as in occlusion.frag

void main() {
  ivec2 here = ivec2(uv * frame.occlusion.xy);
  ivec2 last = ivec2(frame.occlusion.xy) - 1;
  float z = texelFetch(rough, here, 0).y;
  if (z >= 5.9e4) {  // the background's, as a half float has it
    found = vec2(1.0, z);
    return;
  }
  // How steeply the surface recedes, from the flatter side.
  float left = texelFetch(rough, max(here - ivec2(1, 0), ivec2(0)), 0).y;
  float right = texelFetch(rough, min(here + ivec2(1, 0), last), 0).y;
  float above = texelFetch(rough, max(here - ivec2(0, 1), ivec2(0)), 0).y;
  float below = texelFetch(rough, min(here + ivec2(0, 1), last), 0).y;
  float slope = max(min(abs(left - z), abs(right - z)), min(abs(above - z), abs(below - z)));
  float near_enough = 0.01 * z + 3.0 * slope;
  float sum = 0.0;
  float weights = 0.0;
  for (int y = -2; y <= 1; ++y) {
    for (int x = -2; x <= 1; ++x) {
      vec2 there = texelFetch(rough, clamp(here + ivec2(x, y), ivec2(0), last), 0).xy;
      float weight = max(0.0, 1.0 - abs(there.y - z) / near_enough);
      sum += weight * there.x;
      weights += weight;
    }
  }
  found = vec2(sum / weights, z);
}
