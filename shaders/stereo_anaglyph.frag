// One picture for glasses that are red before the left eye and cyan before the right one: of all that a screen can
// show, what through them is the least far from the pair. E. Dubois, "A projection method to generate anaglyph stereo
// images" (Proc. ICASSP 2001); the matrices, which are of linear light, for liquid crystal screens from his
// "Conversion of a stereo pair to anaglyph with the least-squares projection method" (University of Ottawa, 2009).
// Grey stays grey. What lies at the screen keeps its colours: both eyes are to read it.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "include/stereo.glsl"

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 colour;

// Written by rows, so that a row times the matrix is its product with a column.
const mat3 kLeft = mat3(0.437, 0.449, 0.164, -0.062, -0.062, -0.024, -0.048, -0.050, -0.017);
const mat3 kRight = mat3(-0.011, -0.032, -0.007, 0.377, 0.761, 0.009, -0.026, -0.093, 1.234);

// IEC 61966-2-1.
vec3 linear(vec3 c) { return mix(pow((c + 0.055) / 1.055, vec3(2.4)), c / 12.92, lessThanEqual(c, vec3(0.04045))); }
vec3 encoded(vec3 c) {
  return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, lessThanEqual(c, vec3(0.0031308)));
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 light = linear(left_at(pixel)) * kLeft + linear(right_at(pixel)) * kRight;
  colour = with_screen(encoded(clamp(light, 0.0, 1.0)), uv);
}
