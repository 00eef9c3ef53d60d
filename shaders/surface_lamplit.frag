#version 460
#extension GL_GOOGLE_include_directive : require
#define FULCRUM_PUNCTUAL
#include "include/surface.glsl"
