// What may hide light from what the camera sees, in depth alone.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/frame.h"
#include "shared/instance.h"

layout(std140, set = 0, binding = 0) uniform Frame { FrameData frame; };
layout(std430, set = 0, binding = 1) readonly buffer Instances { InstanceData instances[]; };

layout(location = 0) in vec3 mesh_position;

void main() {
  gl_Position = frame.clip_from_world * (instances[gl_InstanceIndex].world_from_mesh * vec4(mesh_position, 1.0));
}
