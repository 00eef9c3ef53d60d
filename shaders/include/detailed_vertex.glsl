// Vertices of detailed surfaces. FULCRUM_WITHOUT_PLACES: of looks that do not read where
// a vertex is in textures.

#include "shared/frame.h"
#include "shared/instance.h"

layout(std140, set = 0, binding = 0) uniform Frame { FrameData frame; };
layout(std430, set = 0, binding = 1) readonly buffer Instances { InstanceData instances[]; };

layout(location = 0) in vec3 mesh_position;
layout(location = 1) in vec3 mesh_normal;
layout(location = 2) in vec4 mesh_colour;
#ifndef FULCRUM_WITHOUT_PLACES
layout(location = 3) in vec4 mesh_uv;
#endif
layout(location = 0) out vec3 world_position;
layout(location = 1) out vec3 world_normal;
layout(location = 2) flat out vec4 base_colour;
layout(location = 3) flat out vec4 surface;
layout(location = 4) out vec3 absorbed;
layout(location = 5) out vec4 uv;

void main() {
  InstanceData self = instances[gl_InstanceIndex];
  vec4 position = self.world_from_mesh * vec4(mesh_position, 1.0);
  world_position = position.xyz;
  world_normal = mat3(self.normal_x.xyz, self.normal_y.xyz, self.normal_z.xyz) * mesh_normal;
  base_colour = self.base_colour;
  surface = self.surface;
  absorbed = 1.0 - mesh_colour.rgb;
#ifdef FULCRUM_WITHOUT_PLACES
  uv = vec4(0.0);
#else
  uv = mesh_uv;
#endif
  gl_Position = frame.clip_from_world * position;
}
