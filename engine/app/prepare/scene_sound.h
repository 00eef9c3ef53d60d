#pragma once
// What a scenario that names `sound` sounds like.

#include <optional>

#include "engine/app/prepare/prepare.h"
#include "engine/audio/scene_sound.h"
#include "engine/render/visual_desc.h"

namespace fulcrum::app {

// None: the scenario does not name it. scene: as the device runs it.
std::optional<audio::SceneSound> scene_sound(const Prepared& prepared, const SceneDesc& scene);

// The camera hears, too.
audio::Listener listener_at(const render::Camera& camera);

}  // namespace fulcrum::app
