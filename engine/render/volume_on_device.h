#pragma once
// A light volume where shaders can read it, with what metal mirrors of the same things.

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>

#include "engine/render/light_volume.h"
#include "engine/render/mirror_volume.h"
#include "engine/vulkan/image.h"

namespace fulcrum::render {

struct VolumeOnDevice {
  VolumeOnDevice() = default;
  // Throws vulkan::Failure.
  VolumeOnDevice(vulkan::Device& device, std::uint32_t seen_layers, const LightVolume& made);
  // Adds what metal mirrors; throws likewise.
  void mirror(vulkan::Device& device, const MirrorVolume& made);

  std::uint32_t layers = ~0U;  // what a camera sees with one of these is in it
  vulkan::Image open, received, sent_on;
  vulkan::Image mirrored, mirrored_sides;                 // none: nothing in the scene mirrors its neighbours
  glm::vec4 from_world{0.0F}, low{0.0F}, unhidden{0.0F};  // as in gpu::FrameData
  glm::vec4 mirror_from_world{0.0F}, mirror_low{0.0F};
};

// Which of them is for a camera of these layers: the first that has one of them, or the first of all.
std::size_t volume_for(std::span<const VolumeOnDevice> volumes, std::uint32_t camera_layers);

}  // namespace fulcrum::render
