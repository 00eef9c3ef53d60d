// A square towards the camera around each marker's sphere, twice as wide for its ring and its glow.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/frame.h"
#include "shared/marker.h"

layout(std140, set = 0, binding = 0) uniform Frame { FrameData frame; };
layout(std430, set = 0, binding = 2) readonly buffer Markers { MarkerData markers[]; };

layout(location = 0) out vec2 at;  // in radii, 0 in the middle
layout(location = 1) flat out MarkerData marker;

const float kReach = 2.0;

void main() {
  marker = markers[gl_InstanceIndex];
  int corner = int[](0, 1, 2, 2, 1, 3)[gl_VertexIndex];
  at = (vec2(corner & 1, corner >> 1) * 2.0 - 1.0) * kReach;
  vec3 offset = (frame.camera_right.xyz * at.x + frame.camera_up.xyz * at.y) * marker.sphere.w;
  gl_Position = frame.clip_from_world * vec4(marker.sphere.xyz + offset, 1.0);
}
