// A pixel of light at surfaces that it spreads below. Of what surface: its distance along the way ahead (m) in a float whose
// last ten bits are its number among those. 0: of none.
#ifndef FULCRUM_SCATTER_TAG_GLSL
#define FULCRUM_SCATTER_TAG_GLSL

const uint kNumberBits = 1023u;
const float kDepthStep = 1.0 / 4096.0;  // of a distance: more than the bits that the number takes are worth

uint tag_of(float ahead, uint number) { return (floatBitsToUint(ahead) & ~kNumberBits) | number; }
uint number_in(uint tag) { return tag & kNumberBits; }
float ahead_in(uint tag) { return uintBitsToFloat(tag & ~kNumberBits); }

// entering: irradiance / pi; gloss: radiance that does not spread.
uvec4 packed_light(vec3 entering, vec3 gloss, uint tag) {
  const float kMost = 6e4;  // a half float holds it
  entering = min(entering, kMost);
  gloss = min(gloss, kMost);
  return uvec4(packHalf2x16(entering.rg), packHalf2x16(vec2(entering.b, gloss.r)), packHalf2x16(gloss.gb), tag);
}
vec3 entering_in(uvec4 light) { return vec3(unpackHalf2x16(light.x), unpackHalf2x16(light.y).x); }
vec3 gloss_in(uvec4 light) { return vec3(unpackHalf2x16(light.y).y, unpackHalf2x16(light.z)); }

#endif
