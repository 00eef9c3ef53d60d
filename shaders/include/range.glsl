// The scene target holds c / (1 + max c), so that 0 <= value < 1: where four samples of an edge are averaged, one very
// bright sample (a highlight on chrome) then weighs no more than the eye would give it, and edges stay smooth.
// B. Karis, "High Quality Temporal Supersampling", SIGGRAPH 2014 course, "tone map before the resolve".
#ifndef FULCRUM_RANGE_GLSL
#define FULCRUM_RANGE_GLSL

vec3 to_target(vec3 c) { return c / (1.0 + max(c.r, max(c.g, c.b))); }

vec3 from_target(vec3 c) {
  c = clamp(c, 0.0, 1.0);
  return c / max(1.0 - max(c.r, max(c.g, c.b)), 0.01);
}

#endif
