#include "engine/render/volume_on_device.h"

#include <algorithm>
#include <glm/gtc/packing.hpp>
#include <vector>

namespace fulcrum::render {
namespace {

constexpr float kBrightestHalf = 60000.0F;  // a half float holds no more
constexpr float kBeforeSurface = 1.25F;     // voxels: a surface fills the one that it lies in

std::vector<std::uint64_t> halves_of(const std::vector<glm::vec4>& voxels) {
  std::vector<std::uint64_t> halves;
  halves.reserve(voxels.size());
  for (const glm::vec4& voxel : voxels)
    halves.push_back(glm::packHalf4x16(glm::clamp(voxel, -kBrightestHalf, kBrightestHalf)));
  return halves;
}

vulkan::Image upload(vulkan::Device& device, const glm::uvec3& counts,
                     std::span<const std::vector<glm::vec4>> levels) {
  std::vector<std::vector<std::uint64_t>> halves;
  for (const std::vector<glm::vec4>& level : levels) halves.push_back(halves_of(level));
  std::vector<std::span<const std::byte>> bytes;
  for (const std::vector<std::uint64_t>& level : halves) bytes.push_back(std::as_bytes(std::span(level)));
  return vulkan::upload_volume(device, VK_FORMAT_R16G16B16A16_SFLOAT, {counts.x, counts.y, counts.z}, bytes);
}

}  // namespace

VolumeOnDevice::VolumeOnDevice(vulkan::Device& device, std::uint32_t seen_layers, const LightVolume& made)
    : layers(seen_layers),
      open(upload(device, made.counts, {&made.open, 1})),
      received(upload(device, made.counts, {&made.received, 1})),
      sent_on(upload(device, made.counts, {&made.sent_on, 1})),
      unhidden(made.unhidden) {
  const glm::vec3 scale = 1.0F / (made.voxel * glm::vec3(made.counts));
  from_world = glm::vec4(scale, kBeforeSurface * made.voxel);
  low = glm::vec4(-made.low * scale, 4.0F * std::min({scale.x, scale.y, scale.z}));
}

void VolumeOnDevice::mirror(vulkan::Device& device, const MirrorVolume& made) {
  mirrored = upload(device, made.counts, made.levels);
  // Both in one image, one above the other: there are devices whose shaders read 16 images at the most.
  std::vector<std::vector<glm::vec4>> sides = made.facing;
  for (std::size_t i = 0; i < sides.size(); ++i)
    sides[i].insert(sides[i].end(), made.bright[i].begin(), made.bright[i].end());
  const glm::uvec3 coarser = glm::max(made.counts / 2U, glm::uvec3(1U));
  mirrored_sides = upload(device, {coarser.x, coarser.y, 2 * coarser.z}, sides);
  const glm::vec3 scale = 1.0F / (made.voxel * glm::vec3(made.counts));
  mirror_from_world = glm::vec4(scale, made.voxel);
  mirror_low = glm::vec4(-made.low * scale, static_cast<float>(made.levels.size() - 1));
}

std::size_t volume_for(std::span<const VolumeOnDevice> volumes, std::uint32_t camera_layers) {
  const auto found = std::ranges::find_if(
      volumes, [&](const VolumeOnDevice& each) { return (each.layers & camera_layers) != 0; });
  return found == volumes.end() ? 0 : static_cast<std::size_t>(found - volumes.begin());
}

}  // namespace fulcrum::render
