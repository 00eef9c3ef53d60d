// Makes one set of structs readable by C++ and GLSL. Only vec4 and mat4 members: both languages lay them out
// alike (std140 and std430 agree on them), and the sizes are asserted in C++.
#ifndef FULCRUM_SHADERS_SHARED_TYPES_H
#define FULCRUM_SHADERS_SHARED_TYPES_H

#ifdef __cplusplus
#include <glm/glm.hpp>
#define FULCRUM_GPU_BEGIN  \
  namespace fulcrum::gpu { \
  using glm::mat4;         \
  using glm::vec4;
#define FULCRUM_GPU_END }
#define FULCRUM_GPU_SIZE(type, bytes) \
  static_assert(sizeof(type) == (bytes), "a GPU struct has one size in C++ and in GLSL")
#else
#define FULCRUM_GPU_BEGIN
#define FULCRUM_GPU_END
#define FULCRUM_GPU_SIZE(type, bytes)
#endif

#endif
