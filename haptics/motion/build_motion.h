#pragma once

#include <memory>

#include "haptics/motion/tool_motion.h"
#include "haptics/scene/plain_scene.h"

namespace fulcrum {

// The one that desc.contact.response names; desc is one that World::build() takes.
std::unique_ptr<ToolMotion> build_motion(const PlainScene& desc);

}  // namespace fulcrum
