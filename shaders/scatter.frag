// What of the light that enters a surface comes out of it at each pixel: the mean of what enters around, each place
// weighed by Burley's profile at its distance in space (engine/render/scatter_taps.h), of this surface alone. Weights are
// taken to a sum of one, so that even light stays as it is, up to an edge; they have steps where a surface has them, for
// what is as near in the picture is far away behind. Four by four pixels look at other places each: scattered.glsl puts
// them together.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "include/scatter_tag.glsl"
#include "shared/frame.h"

layout(constant_id = 0) const uint kTaps = 16;

layout(std140, set = 0, binding = 0) uniform Frame { FrameData frame; };
layout(set = 0, binding = 1) uniform usampler2D entering;
layout(std430, set = 0, binding = 2) readonly buffer Distances { vec4 distances[]; };
layout(std430, set = 0, binding = 3) readonly buffer Taps { vec4 taps[]; };

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 comes_out;  // rgb irradiance / pi, a as in scatter_tag.glsl

const float kLeastPart = 1e-3;  // of the greatest distance: less is none
const float kSelf = 1e-6;       // weight of the pixel itself: where nothing else counts, it alone does

void main() {
  ivec2 here = ivec2(gl_FragCoord.xy);
  ivec2 size = textureSize(entering, 0);
  uvec4 self = texelFetch(entering, here, 0);
  uint number = number_in(self.a);
  comes_out = vec4(entering_in(self), uintBitsToFloat(self.a));
  if (number == 0u) {
    return;
  }
  vec4 d = distances[number - 1u];
  vec3 inverse = d.w / max(d.rgb, kLeastPart * d.w);
  float z = ahead_in(self.a);
  vec2 ray = (uv * vec2(2.0, -2.0) + vec2(-1.0, 1.0)) * frame.lens.xy + frame.lens.zw;  // x right, y up, 1 ahead
  vec2 per = vec2(size) * d.w / (2.0 * z * frame.lens.xy) * vec2(1.0, -1.0);           // pixels
  // What is put together lies half a pixel to the left and above.
  vec2 middle = gl_FragCoord.xy + 0.5 * clamp(abs(per), vec2(1e-4), vec2(1.0));
  uint first = uint((here.y & 3) * 4 + (here.x & 3)) * kTaps;
  vec3 sum = kSelf * comes_out.rgb;
  vec3 weights = vec3(kSelf);
  for (uint i = first; i < first + kTaps; ++i) {
    vec4 tap = taps[i];
    ivec2 at = ivec2(floor(middle + per * tap.xy));
    if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, size))) {
      continue;
    }
    uvec4 there = texelFetch(entering, at, 0);
    if (number_in(there.a) != number) {
      continue;
    }
    float farther = (ahead_in(there.a) - z) / d.w;
    float r = length(vec3(ray * farther + tap.xy * (1.0 + farther * d.w / z), farther));
    vec3 fall = exp(inverse * (-r / 3.0));
    vec3 weight = inverse * (fall * fall * fall + fall) * (tap.w / max(r, 1e-6));
    sum += weight * entering_in(there);
    weights += weight;
  }
  comes_out.rgb = sum / weights;
}
