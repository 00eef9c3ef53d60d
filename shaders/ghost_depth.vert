// The ghost's own surface, in depth alone: what hides its rear lines.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/ghost.h"

layout(push_constant) uniform Draw { GhostDraw draw; };

layout(location = 0) in vec3 position;

void main() { gl_Position = draw.clip_from_ghost * vec4(position, 1.0); }
