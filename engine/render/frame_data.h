#pragma once
// From camera, light and time to what shaders read.

#include "engine/render/environment.h"
#include "engine/render/frame_state.h"
#include "engine/render/light_fit.h"
#include "engine/render/plan.h"
#include "engine/render/volume_on_device.h"
#include "shaders/shared/frame.h"
#include "shaders/shared/marker.h"

namespace fulcrum::render {

// The parts of a VisualDesc that every frame needs.
struct Setting {
  std::optional<KeyLight> key_light;
  Irradiance around;
  Background background;
};

// The camera's frame: x to the right, y up, z to the back.
glm::mat4 view_of(const Camera& camera);

// What is nearer to the eye along the camera's axis is not in the picture (m): half a centimetre, and in a
// scene so small that its camera is nearer to its target than ten, a twentieth of the way there.
float nearest_seen(const Camera& camera);

// Clip space with the depth reversed (1 near, 0 infinitely far), Y up.
glm::mat4 clip_from_world(const Camera& camera, Extent picture);

// scene: what the picture is drawn as.
gpu::FrameData frame_data(const Setting& setting, const FrameState& state, Extent picture, Extent scene,
                          const LightFit& light, int shadow_size);

void write_volume(const VolumeOnDevice& volume, gpu::FrameData& to);

// The markers that are to be seen, written to `to` one after another; returns how many.
std::uint32_t write_markers(std::span<const Marker> markers, std::span<const MarkerState> states,
                            const MarkerColours& colours, gpu::MarkerData* to);

}  // namespace fulcrum::render
