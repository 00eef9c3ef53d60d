// Where a surface has holes it throws no shadow and hides no light.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "include/holes.glsl"
#include "shared/material.h"

layout(set = 1, binding = 0) uniform Material { MaterialData material; };
layout(set = 1, binding = 1) uniform sampler2D base_map;

layout(location = 0) in vec4 uv;

void main() {
  vec2 from = material.uv_shift[FULCRUM_TEXTURE_BASE].z > 0.5 ? uv.zw : uv.xy;
  vec4 turn = material.uv_turn[FULCRUM_TEXTURE_BASE];
  vec2 at = vec2(dot(turn.xy, from), dot(turn.zw, from)) + material.uv_shift[FULCRUM_TEXTURE_BASE].xy;
  if (!is_there(part_there(base_map, at, texture(base_map, at).a, material.emission.w / max(material.amounts.z, 1e-6)))) {
    discard;
  }
}
