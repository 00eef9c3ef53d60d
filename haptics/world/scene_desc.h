#pragma once
// A scene as plain data. World::build() turns it into what ticks; a part that is not named here is not built.

#include "haptics/effects/effects.h"
#include "haptics/scene/plain_scene.h"

namespace fulcrum {

struct SceneDesc : PlainScene, EffectDescs {};

// Something in the scene asks for impacts.
inline bool detects_impacts(const SceneDesc& desc) {
  return asks_for_impacts(desc, desc);
}

}  // namespace fulcrum
