// A glowing sphere: a shell that is brightest at its rim, a soft glow, and for a dwell a ring that fills clockwise
// from the top. It covers a little of what is behind it, or it would vanish before a bright wall.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/frame.h"
#include "shared/marker.h"

layout(std140, set = 0, binding = 0) uniform Frame { FrameData frame; };
layout(push_constant) uniform Visibility { float visibility; };  // less than 1 where something stands before it

layout(location = 0) in vec2 at;
layout(location = 1) flat in MarkerData marker;
layout(location = 0) out vec4 colour;

const float kTau = 6.2831853;

float ring(float radius, float middle, float half_width, float pixel) {
  return 1.0 - smoothstep(half_width - pixel, half_width + pixel, abs(radius - middle));
}

void main() {
  float radius = length(at);
  float pixel = fwidth(radius);
  int kind = int(marker.state.x + 0.5);
  float pulse = kind == FULCRUM_MARKER_DONE ? 0.6 : 0.88 + 0.12 * sin(kTau * 0.6 * frame.eye.w);

  // Inside: what a thin glowing shell shows, more of itself where it is seen edge on.
  float facing = sqrt(max(1.0 - radius * radius, 0.0));
  float inside = 1.0 - smoothstep(1.0 - pixel, 1.0 + pixel, radius);
  float shell = (0.34 + 0.66 * pow(1.0 - facing, 2.0)) * inside;
  float halo = (1.0 - inside) * 0.45 * exp(-5.0 * (radius - 1.0)) * (1.0 - smoothstep(1.5, 2.0, radius));
  float light = (shell + halo) * pulse;
  float cover = min(1.5 * light, 1.0);

  if (kind == FULCRUM_MARKER_DWELLING) {
    float turn = fract(atan(at.x, at.y) / kTau + 1.0);  // 0 at the top, clockwise
    float filled = 1.0 - smoothstep(marker.state.y - 0.004, marker.state.y + 0.004, turn);
    float band = ring(radius, 1.5, 0.12, pixel);
    light = mix(light, mix(0.08, 0.95, filled), band);
    cover = mix(cover, mix(0.55, 1.0, filled), band);
  }
  colour = vec4(marker.tint.rgb * light, cover) * visibility;
}
