#version 460
#extension GL_GOOGLE_include_directive : require
#define FULCRUM_WITHOUT_PLACES
#include "include/detailed_vertex.glsl"
