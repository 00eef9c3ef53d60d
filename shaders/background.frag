#version 460
#extension GL_GOOGLE_include_directive : require
#include "include/range.glsl"
#include "shared/frame.h"

layout(std140, set = 0, binding = 0) uniform Frame { FrameData frame; };

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 colour;

void main() {
  vec3 radiance = mix(frame.background_top.rgb, frame.background_bottom.rgb, smoothstep(0.0, 1.0, uv.y));
  colour = vec4(to_target(radiance), 1.0);
}
