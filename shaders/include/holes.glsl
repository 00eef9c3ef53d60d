// Where a texture cuts a surface out. Included by detailed.glsl and masked_shadow.frag.

#include "dither.glsl"

// x: the part of a pixel that is there, of a texture with that alpha at coordinates `at` of its picture; below cut_off there
// is nothing. Of a picture that is enlarged (y 0) the edge is a pixel wide; in its smaller sizes (y 1) alpha is that part.
vec2 part_there(sampler2D picture, vec2 at, float alpha, float cut_off) {
  vec2 pixels = at * vec2(textureSize(picture, 0));
  vec2 dx = dFdx(pixels);
  vec2 dy = dFdy(pixels);
  float smaller = clamp(0.5 * log2(max(max(dot(dx, dx), dot(dy, dy)), 1e-12)), 0.0, 1.0);
  float edge = clamp((alpha - cut_off) / max(fwidth(alpha), 1e-4) + 0.5, 0.0, 1.0);
  return vec2(cut_off > 1.0 ? 0.0 : mix(edge, alpha, smaller), smaller);
}

// Whether a pixel with one sample is: on one side of an edge, and of many pixels as many as there is of the surface.
bool is_there(vec2 part) {
  float least = clamp(0.5 + 255.0 * dither(gl_FragCoord.xy), 0.01, 0.99);
  return part.x >= mix(0.5, least, part.y);
}
