// A finished picture of the scene that was drawn smaller, as large as it is shown: first along its rows, then along the
// columns of what that gives.
//
// E. Catmull and R. Rom, "A Class of Local Interpolating Splines", 1974; held between the two pixels around, so that it
// rings at no edge. It works on what the screen shows: of light itself, a bright pixel would swallow its neighbours.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "include/dither.glsl"

layout(constant_id = 0) const uint kAlongColumns = 0;

layout(set = 0, binding = 0) uniform sampler2D small;

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 colour;

vec4 weights(float t) {
  float t2 = t * t;
  float t3 = t2 * t;
  return vec4(-0.5 * t + t2 - 0.5 * t3, 1.0 - 2.5 * t2 + 1.5 * t3, 0.5 * t + 2.0 * t2 - 1.5 * t3, 0.5 * (t3 - t2));
}

vec3 pixel(ivec2 at, ivec2 size) { return texelFetch(small, clamp(at, ivec2(0), size - 1), 0).rgb; }

void main() {
  ivec2 size = textureSize(small, 0);
  ivec2 along = ivec2(1, 0);  // not chosen with ?: as Mesa 22.3 takes one component of a constant vector for both
  if (kAlongColumns == 1) {
    along = ivec2(0, 1);
  }
  float at = dot(uv * vec2(size), vec2(along)) - 0.5;
  float before = floor(at);
  ivec2 first = ivec2(gl_FragCoord.xy) * (1 - along) + int(before) * along;
  vec4 weight = weights(at - before);
  vec3 left = pixel(first, size);
  vec3 right = pixel(first + along, size);
  vec3 sum = weight.x * pixel(first - along, size) + weight.y * left + weight.z * right +
             weight.w * pixel(first + 2 * along, size);
  vec3 held = clamp(sum, min(left, right), max(left, right));
  colour = vec4(kAlongColumns == 0 ? held : held + dither(gl_FragCoord.xy), 1.0);
}
