#pragma once
// One descriptor set, its layout and its pool, made from a list of bindings.

#include <vector>

#include "engine/vulkan/device.h"
#include "engine/vulkan/handle.h"

namespace fulcrum::vulkan {

// A buffer or an image with its sampler; the one whose type is named.
struct Binding {
  std::uint32_t number = 0;
  VkDescriptorType type = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
  VkShaderStageFlags stages = 0;
  VkBuffer buffer = VK_NULL_HANDLE;  // all of it
  VkImageView view = VK_NULL_HANDLE;
  VkSampler sampler = VK_NULL_HANDLE;
};

class DescriptorSet {
public:
  DescriptorSet() = default;
  // Throws Failure.
  DescriptorSet(Device& device, const std::vector<Binding>& bindings);

  VkDescriptorSetLayout layout() const { return layout_.get(); }
  VkDescriptorSet get() const { return set_; }

private:
  SetLayoutHandle layout_;
  DescriptorPoolHandle pool_;
  VkDescriptorSet set_ = VK_NULL_HANDLE;  // freed with its pool
};

SamplerHandle make_sampler(Device& device, const VkSamplerCreateInfo& info);

}  // namespace fulcrum::vulkan
