// The surroundings behind everything, as sharp as a mirror shows them, by a cubic B-spline: what is as large as a pixel of
// their map is many in the picture, and lines between pixels would be seen to have steps.
//
// Sixteen pixels by four reads: C. Sigg and M. Hadwiger, "Fast Third-Order Texture Filtering", GPU Gems 2, 2005.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "include/octahedral.glsl"
#include "include/range.glsl"
#include "shared/frame.h"

layout(std140, set = 0, binding = 0) uniform Frame { FrameData frame; };
layout(set = 0, binding = 4) uniform sampler2D surroundings;  // engine/render/environment.h

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 colour;

vec3 smooth_at(vec2 place) {
  vec2 size = vec2(textureSize(surroundings, 0));
  vec2 at = place * size - 0.5;
  vec2 low = floor(at);
  vec2 f = at - low;
  vec2 before = (1.0 - f) * (1.0 - f) * (1.0 - f) / 6.0;
  vec2 after = f * f * f / 6.0;
  vec2 here = 2.0 / 3.0 - f * f * (1.0 - 0.5 * f);
  vec2 next = 1.0 - before - here - after;
  vec2 left = (low - 0.5 + here / (before + here)) / size, right = (low + 1.5 + after / (next + after)) / size;
  vec2 share = next + after;
  vec3 upper = mix(textureLod(surroundings, left, 0.0).rgb, textureLod(surroundings, vec2(right.x, left.y), 0.0).rgb, share.x);
  vec3 lower = mix(textureLod(surroundings, vec2(left.x, right.y), 0.0).rgb, textureLod(surroundings, right, 0.0).rgb, share.x);
  return mix(upper, lower, share.y);
}

void main() {
  vec2 across = vec2(2.0, -2.0) * uv + vec2(-1.0, 1.0);
  vec2 aside = across * frame.lens.xy + frame.lens.zw;
  vec3 right = frame.camera_right.xyz, up = frame.camera_up.xyz;
  vec3 d = cross(up, right) + aside.x * right + aside.y * up;
  colour = vec4(to_target(smooth_at(place_on_map(d))), 1.0);
}
