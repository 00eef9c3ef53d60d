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

// The part of a sample above which that sample counts as there. At an edge it is half of one. Of what is seen from afar it
// differs from pixel to pixel, evenly between 0 and 1: over many pixels, as many samples are there as there is of the surface.
float least_there(vec2 part) { return mix(0.5, clamp(0.5 + 255.0 * dither(gl_FragCoord.xy), 0.01, 0.99), part.y); }

// Whether a pixel with one sample is there.
bool is_there(vec2 part) { return part.x >= least_there(part); }

// The alpha for which a device covers as many of four samples as there are: all of them for 1, as all devices do. Else they
// round as they like, lavapipe up, others to the nearest: a little less than whole samples is the same to both, and those that
// round by the place of a pixel come near it.
float alpha_of_samples(vec2 part) {
  float samples = floor(4.0 * part.x + 1.0 - least_there(part));
  return samples >= 4.0 ? 1.0 : max(samples - 0.25, 0.0) / 4.0;
}
