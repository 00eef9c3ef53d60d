#version 460
#extension GL_GOOGLE_include_directive : require
#define FULCRUM_OCCLUDED
#include "include/detailed.glsl"
