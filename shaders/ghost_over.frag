// Lays the ghost's lines over the finished picture: a bright core on a dark halo, seen on white and on black alike.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/ghost.h"

layout(set = 0, binding = 3) uniform sampler2D lines;
layout(push_constant) uniform Draw { GhostDraw draw; };

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 colour;  // premultiplied, sRGB encoded

const float kDarkness = 0.6;  // of the halo

void main() {
  vec2 coverage = texture(lines, uv).rg;
  if (coverage.y <= 0.0) {
    discard;
  }
  float core = coverage.x * draw.colour.a;
  float halo = coverage.y * draw.colour.a * kDarkness;
  colour = vec4(draw.colour.rgb * core, core + halo * (1.0 - core));
}
