#version 460
#extension GL_GOOGLE_include_directive : require
#define FULCRUM_MULTISAMPLED
#include "include/ghost_line.glsl"
