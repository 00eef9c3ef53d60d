// The left eye's picture in the even rows, counted from 0 at the top, the right eye's in the odd ones.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "include/stereo.glsl"

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 colour;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  colour = with_screen((pixel.y & 1) == 0 ? left_at(pixel) : right_at(pixel), uv);
}
