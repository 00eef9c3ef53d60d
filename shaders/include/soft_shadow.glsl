// Shadows with edges as wide as the light's size makes them. Included by shading.glsl.
//
// Percentage-closer soft shadows: R. Fernando, SIGGRAPH 2005. What hides light is looked for first; how far it is away in
// the mean tells how wide the filter has to be. Here both look into the cone from a place to the light alone: a texel
// counts only if it is so far before the place that the cone reaches it. A slanted surface is never its own shadow so.
// Places on a disc by the golden angle: H. Vogel, Mathematical Biosciences, 1979; turned in each pixel by J. Jimenez's
// interleaved gradient noise, SIGGRAPH 2014, so that few of them leave no steps.

layout(set = 0, binding = 9) uniform sampler2D shadow_depth;

const int kLookedAt = 12;   // gathers beyond the nearest 4 x 4 texels
const int kCompared = 16;  // bilinear comparisons
const float kRim = 2.0;    // texels in which depth in the map tells nothing of a slope: no cone there
const mat2 kGoldenTurn = mat2(-0.73736888, 0.67549029, -0.67549029, -0.73736888);

// x how many of the texels hide light, y their depths' sum.
vec2 hiding(vec2 at, float nearest) {
  vec4 found = textureGather(shadow_depth, at);
  vec4 hides = vec4(lessThan(found, vec4(nearest)));
  return vec2(dot(hides, vec4(1.0)), dot(hides, found));
}

// How much of the light reaches a place of the map.
float filtered_shadow(vec2 uv, float depth) {
  float texel = frame.shadow.x;
  float spread = frame.shadow.z;
  float reached = min(depth, 1.0);  // what is beyond the map's depth has all of the map before it
  float turn = 6.2831853 * fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  vec2 start = vec2(cos(turn), sin(turn));

  vec2 low = floor(uv / texel - 0.5) * texel;
  vec2 high = low + 2.0 * texel;
  vec2 found = hiding(low, reached) + hiding(vec2(high.x, low.y), reached) +
               hiding(vec2(low.x, high.y), reached) + hiding(high, reached);
  vec2 towards = start;
  for (int i = 0; i < kLookedAt; ++i) {
    // Denser near the middle: what is near the place hides all of the light within a small part of the map.
    float part = (float(i) + 1.0) / float(kLookedAt);
    float away = spread * depth * part * sqrt(part);
    towards = kGoldenTurn * towards;
    found += hiding(uv + away * towards, min(depth - max(away - kRim * texel, 0.0) / spread, 1.0));
  }

  int count = found.x > 0.0 ? kCompared : 0;
  float radius = max(spread * (depth - found.y / max(found.x, 1.0)), 1.5 * texel);
  float lit = 0.0;
  towards = start;
  for (int i = 0; i < count; ++i) {
    float away = radius * sqrt((float(i) + 0.5) / float(kCompared));
    towards = kGoldenTurn * towards;
    // Not quite the cone: what is as far away as all that hides has to count out to the rim.
    float nearest = depth - 0.8 * max(away - kRim * texel, 0.0) / spread;
    lit += textureLod(shadow_map, vec3(uv + away * towards, min(nearest, 1.0)), 0.0);
  }
  return count > 0 ? lit / float(kCompared) : 1.0;
}
