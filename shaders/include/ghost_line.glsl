// How much of a pixel a line of the ghost covers: its bright core and its dark halo. Included by ghost_line.frag and
// ghost_line_multisampled.frag. Where lines overlap, the larger coverage counts: order and joints leave no trace.
//
// Whether something hides the line is asked once for its whole width, at the nearest point of its middle: asked for
// each pixel, half the width of every outline would lie inside the surface that it bounds.

#include "../shared/ghost.h"

layout(set = 0, binding = 1) uniform sampler2D ghost_depth;
#ifdef FULCRUM_MULTISAMPLED
layout(set = 0, binding = 2) uniform sampler2DMS scene_depth;
#else
layout(set = 0, binding = 2) uniform sampler2D scene_depth;
#endif
layout(push_constant) uniform Draw { GhostDraw draw; };

layout(location = 0) flat in vec4 ends;
layout(location = 1) flat in vec2 depths;
layout(location = 0) out vec2 coverage;  // x core, y halo

const float kBehind = 0.38;     // what is left of a line behind the scene or the tool: a trainee must still see it
const float kSlack = 0.0006;    // of the distance to the eye: a line lies in the surface that it is an edge of
const float kSoftness = 0.002;  // of the distance: over which a line that goes behind something fades

ivec2 inside(vec2 at, vec2 size) { return clamp(ivec2(floor(at)), ivec2(0), ivec2(size) - 1); }

float ghost_at(vec2 at) { return texelFetch(ghost_depth, inside(at, draw.size.xy), 0).r; }
float scene_at(vec2 at) {
  return texelFetch(scene_depth, inside(at * draw.size.zw, round(draw.size.xy * draw.size.zw)), 0).r;
}

// The farthest surface around a pixel: an outline has what it bounds on one side only, and must not be hidden by it.
#define FULCRUM_FARTHEST(depth_at, at)                                                  \
  min(min(depth_at(at), min(depth_at(at + vec2(1.0, 1.0)), depth_at(at - vec2(1.0)))), \
      min(depth_at(at + vec2(1.0, -1.0)), depth_at(at + vec2(-1.0, 1.0))))

void main() {
  vec2 along = ends.zw - ends.xy;
  float t = clamp(dot(gl_FragCoord.xy - ends.xy, along) / max(dot(along, along), 1e-6), 0.0, 1.0);
  vec2 at = ends.xy + t * along;
  float from_middle = distance(gl_FragCoord.xy, at);
  float core = clamp(draw.width.x + 0.5 - from_middle, 0.0, 1.0);
  float halo = 1.0 - smoothstep(draw.width.x, draw.width.x + draw.width.y, from_middle);
  if (core <= 0.0 && halo <= 0.0) {
    discard;
  }
  float depth = mix(depths.x, depths.y, t);
  if (depth < FULCRUM_FARTHEST(ghost_at, at) * (1.0 - kSlack)) {
    discard;
  }
  float surface = FULCRUM_FARTHEST(scene_at, at);
  float behind = surface > 0.0 ? smoothstep(kSlack, kSoftness, 1.0 - depth / surface) : 0.0;
  coverage = vec2(core, halo) * mix(1.0, kBehind, behind);
}
