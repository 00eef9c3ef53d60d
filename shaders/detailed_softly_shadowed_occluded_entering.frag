#version 460
#extension GL_GOOGLE_include_directive : require
#define FULCRUM_SHADOWED
#define FULCRUM_SOFT
#define FULCRUM_OCCLUDED
#define FULCRUM_ENTERING
#include "include/detailed.glsl"
