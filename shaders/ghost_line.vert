// A rectangle around each line, of constant width in pixels, wide enough for its halo and its round ends.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/ghost.h"

layout(std430, set = 0, binding = 0) readonly buffer Lines { GhostLine lines[]; };
layout(push_constant) uniform Draw { GhostDraw draw; };

layout(location = 0) flat out vec4 ends;    // xy where it begins, zw where it ends (pixels)
layout(location = 1) flat out vec2 depths;  // there; between them depth is linear on the picture

// Clipped at the near plane, where reversed depth z / w is 1.
vec4 clipped(vec4 p, vec4 towards) {
  return p.w < p.z ? mix(p, towards, (p.z - p.w) / (towards.w - p.w)) : p;
}

vec2 pixel(vec4 clip) { return (clip.xy / clip.w * vec2(0.5, -0.5) + 0.5) * draw.size.xy; }

void main() {
  vec4 from = draw.clip_from_ghost * vec4(lines[gl_InstanceIndex].from.xyz, 1.0);
  vec4 to = draw.clip_from_ghost * vec4(lines[gl_InstanceIndex].to.xyz, 1.0);
  if (from.w < from.z && to.w < to.z) {
    ends = vec4(0.0);
    depths = vec2(0.0);
    gl_Position = vec4(2.0, 2.0, 0.0, 1.0);  // behind the eye: all corners in one place, outside the picture
    return;
  }
  vec4 a = clipped(from, to);
  vec4 b = clipped(to, from);
  ends = vec4(pixel(a), pixel(b));
  depths = vec2(a.z / a.w, b.z / b.w);

  vec2 along = ends.zw - ends.xy;
  float len = length(along);
  along = len > 1e-3 ? along / len : vec2(1.0, 0.0);
  vec2 across = vec2(-along.y, along.x);
  int corner = int[](0, 1, 2, 2, 1, 3)[gl_VertexIndex];
  float reach = draw.width.x + draw.width.y;
  vec2 at = (corner & 1) == 0 ? ends.xy - along * reach : ends.zw + along * reach;
  at += across * ((corner >> 1) == 0 ? -reach : reach);
  gl_Position = vec4((at / draw.size.xy - 0.5) * vec2(2.0, -2.0), 0.5, 1.0);
}
