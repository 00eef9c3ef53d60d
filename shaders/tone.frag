// Scene radiance to an sRGB-encoded picture.
//
// AgX by T. Sobotka; the fitted matrices and the sixth-order fit of its curve are those of B. Wrensch, "Minimal AgX
// Implementation", 2023 (iolite-engine.com/blog_posts/minimal_agx_implementation), with its "punchy" idea of a look.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "include/dither.glsl"
#include "include/range.glsl"

layout(set = 0, binding = 0) uniform sampler2D scene;

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 colour;

const mat3 kInset = mat3(0.842479062253094, 0.0423282422610123, 0.0423756549057051,
                         0.0784335999999992, 0.878468636469772, 0.0784336,
                         0.0792237451477643, 0.0791661274605434, 0.879142973793104);
const mat3 kOutset = mat3(1.19687900512017, -0.0528968517574562, -0.0529716355144438,
                          -0.0980208811401368, 1.15190312990417, -0.0980434501171241,
                          -0.0990297440797205, -0.0989611768448433, 1.15107367264116);
const float kMinEv = -12.47393;
const float kMaxEv = 4.026069;

vec3 curve(vec3 x) {
  vec3 x2 = x * x;
  vec3 x4 = x2 * x2;
  return 15.5 * x4 * x2 - 40.14 * x4 * x + 31.96 * x4 - 6.868 * x2 * x + 0.4298 * x2 + 0.1191 * x - 0.00232;
}

// Sobotka's curve is flat by design; a trainee should see edges: more contrast, more saturation.
vec3 look(vec3 c) {
  c = pow(max(c, 0.0), vec3(1.35));
  float luma = dot(c, vec3(0.2126, 0.7152, 0.0722));
  return luma + 1.2 * (c - luma);
}

void main() {
  vec3 radiance = from_target(texture(scene, uv).rgb);
  vec3 ev = clamp(log2(max(kInset * radiance, 1e-10)), kMinEv, kMaxEv);
  vec3 encoded = kOutset * look(curve((ev - kMinEv) / (kMaxEv - kMinEv)));  // encoded for the screen already
  colour = vec4(encoded + dither(gl_FragCoord.xy), 1.0);
}
