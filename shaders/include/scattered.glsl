// What light comes out of a surface after it has spread below it. Included by detailed.glsl.

#include "scatter_tag.glsl"

layout(set = 0, binding = 11) uniform sampler2D scattered;  // of scatter.frag
layout(set = 0, binding = 12) uniform usampler2D entering;  // packed_light()

struct Below {
  vec3 comes_out;  // irradiance / pi
  vec3 gloss;      // radiance
};

// Of what comes out, the mean of four by four pixels, which have looked at sixteen times as many places, of this surface; of
// the one here alone where light spreads by less than a pixel. Of what does not spread, the pixel's here; a sample of an
// edge whose pixel is another surface's has a neighbour's. otherwise: where there is none, for a surface thinner than that.
Below light_from_below(vec3 otherwise) {
  uint number = uint(surface.z + 0.5);
  float z = 1.0 / gl_FragCoord.w;
  ivec2 size = textureSize(scattered, 0);
  float pixels = material.scattering.w * float(size.y) / (2.0 * frame.lens.y * z);
  float beside = clamp(pixels, 1e-4, 1.0);
  float near_enough = material.scattering.w + 3.0 * fwidth(z) + z * kDepthStep;
  ivec2 here = ivec2(gl_FragCoord.xy);
  ivec2 nearest = here;
  float most = 0.0;
  vec3 sum = 1e-6 * otherwise;
  float weights = 1e-6;
  for (int y = -2; y <= 1; ++y) {
    for (int x = -2; x <= 1; ++x) {
      ivec2 at = clamp(here + ivec2(x, y), ivec2(0), size - 1);
      vec4 there = texelFetch(scattered, at, 0);
      uint tag = floatBitsToUint(there.a);
      float weight = max(1.0 - abs(ahead_in(tag) - z) / near_enough, 0.0);
      weight = number_in(tag) == number ? weight : 0.0;
      float near = weight / float(1 + x * x + y * y);
      nearest = near > most ? at : nearest;
      most = max(near, most);
      weight *= x == 0 && y == 0 ? 1.0 : beside;
      sum += weight * there.rgb;
      weights += weight;
    }
  }
  vec3 gloss = gloss_in(texelFetch(entering, nearest, 0));
  return Below(sum / weights, most > 0.0 ? gloss : vec3(0.0));
}
