// The left eye's picture in the left or the upper half, the right eye's in the other one. What lies at the screen is
// squeezed, too, so that either eye finds it at the same place.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "include/stereo.glsl"

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 colour;

void main() {
  ivec2 half_size = textureSize(left_eye, 0);
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  bvec2 beyond = greaterThanEqual(pixel, half_size);
  pixel -= half_size * ivec2(beyond);
  vec3 seen = any(beyond) ? right_at(pixel) : left_at(pixel);
  vec2 stretch = vec2(textureSize(at_screen, 0)) / vec2(half_size);
  colour = with_screen(seen, uv * stretch - vec2(beyond));
}
