#pragma once
// A scene at a moment as another renderer needs it: meshes, materials, poses, lights and camera as ours gets
// them. tools/blender/reference.py reads it.

#include <string>

#include "engine/render/visual_desc.h"
#include "engine/studies/picture_shot.h"

namespace fulcrum::app {

struct SceneDescription {
  std::string json;    // what there is, and where in `bytes` its numbers are
  std::string bytes;   // float32 and uint32, little-endian
  std::string digest;  // SHA-256 of all that a reference depends on
};

// desc: with the shot's instances. What the camera does not see is left out. The background is not in it:
// it is laid under a reference afterwards.
SceneDescription describe(const render::VisualDesc& desc, const Shot& shot);

}  // namespace fulcrum::app
