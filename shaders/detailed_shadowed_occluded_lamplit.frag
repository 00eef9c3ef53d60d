#version 460
#extension GL_GOOGLE_include_directive : require
#define FULCRUM_SHADOWED
#define FULCRUM_OCCLUDED
#define FULCRUM_PUNCTUAL
#include "include/detailed.glsl"
