#version 460
#extension GL_GOOGLE_include_directive : require
#define FULCRUM_PUNCTUAL
#define FULCRUM_ENTERING
#include "include/detailed.glsl"
