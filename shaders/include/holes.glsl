// Where a texture cuts a surface out. Included by detailed.glsl and masked_shadow.frag.

#include "dither.glsl"

// x: the part of a pixel that is there, of a texture with that alpha at coordinates `at` of its picture; below cut_off there
// is nothing. Of a picture that is enlarged (y 0) the edge is a pixel wide; in its smaller sizes (y 1) alpha is that part.
vec2 part_there(sampler2D picture, vec2 at, float alpha, float cut_off) {
  float smaller = clamp(textureQueryLod(picture, at).x, 0.0, 1.0);
  // What is as high as cut_off is there.
  float edge = clamp((alpha - cut_off + 0.5e-4) / max(fwidth(alpha), 1e-4) + 0.5, 0.0, 1.0);
  return vec2(mix(edge, alpha, smaller), smaller);
}

// Whether a pixel with one sample is: on one side of an edge, and of many pixels as many as there is of the surface.
bool is_there(vec2 part) {
  float least = clamp(0.5 + 255.0 * dither(gl_FragCoord.xy), 0.01, 0.99);
  return part.x >= mix(0.5, least, part.y);
}
