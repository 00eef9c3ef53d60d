#include "engine/vulkan/descriptors.h"

namespace fulcrum::vulkan {

namespace {

void point(VkDevice device, VkDescriptorSet set, const Binding& binding) {
  const VkDescriptorBufferInfo buffer{binding.buffer, 0, VK_WHOLE_SIZE};
  const VkDescriptorImageInfo image{binding.sampler, binding.view, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
  VkWriteDescriptorSet write{};
  write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
  write.dstSet = set;
  write.dstBinding = binding.number;
  write.descriptorCount = 1;
  write.descriptorType = binding.type;
  write.pBufferInfo = binding.buffer == VK_NULL_HANDLE ? nullptr : &buffer;
  write.pImageInfo = binding.view == VK_NULL_HANDLE ? nullptr : &image;
  vkUpdateDescriptorSets(device, 1, &write, 0, nullptr);
}

}  // namespace

DescriptorSet::DescriptorSet(Device& device, const std::vector<Binding>& bindings) {
  std::vector<VkDescriptorSetLayoutBinding> layout_bindings;
  std::vector<VkDescriptorPoolSize> sizes;
  for (const Binding& binding : bindings) {
    layout_bindings.push_back({binding.number, binding.type, 1, binding.stages, nullptr});
    sizes.push_back({binding.type, 1});
  }
  VkDescriptorSetLayoutCreateInfo layout{};
  layout.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
  layout.bindingCount = static_cast<std::uint32_t>(layout_bindings.size());
  layout.pBindings = layout_bindings.data();
  VkDescriptorSetLayout layout_object = VK_NULL_HANDLE;
  check(vkCreateDescriptorSetLayout(device.get(), &layout, nullptr, &layout_object),
        "lay out a descriptor set");
  layout_ = SetLayoutHandle(device.get(), layout_object);

  VkDescriptorPoolCreateInfo pool{};
  pool.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
  pool.maxSets = 1;
  pool.poolSizeCount = static_cast<std::uint32_t>(sizes.size());
  pool.pPoolSizes = sizes.data();
  VkDescriptorPool pool_object = VK_NULL_HANDLE;
  check(vkCreateDescriptorPool(device.get(), &pool, nullptr, &pool_object), "make a descriptor pool");
  pool_ = DescriptorPoolHandle(device.get(), pool_object);

  VkDescriptorSetAllocateInfo allocate{};
  allocate.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
  allocate.descriptorPool = pool_object;
  allocate.descriptorSetCount = 1;
  allocate.pSetLayouts = &layout_object;
  check(vkAllocateDescriptorSets(device.get(), &allocate, &set_), "make a descriptor set");
  for (const Binding& binding : bindings) point(device.get(), set_, binding);
}

SamplerHandle make_sampler(Device& device, const VkSamplerCreateInfo& info) {
  VkSampler sampler = VK_NULL_HANDLE;
  check(vkCreateSampler(device.get(), &info, nullptr, &sampler), "make a sampler");
  return {device.get(), sampler};
}

}  // namespace fulcrum::vulkan
