#include "engine/vulkan/memory.h"

#include <algorithm>
#include <array>
#include <utility>

#include "engine/vulkan/result.h"

namespace fulcrum::vulkan {

struct Allocation::Block {
  Block(VkDevice on, VkDeviceSize size) : device(on), list(size) {}
  Block(const Block&) = delete;
  Block& operator=(const Block&) = delete;
  ~Block() { vkFreeMemory(device, memory, nullptr); }  // unmaps, too

  VkDevice device;
  VkDeviceMemory memory = VK_NULL_HANDLE;
  std::byte* mapped = nullptr;
  std::uint32_t type = 0;
  bool image = false;
  FreeList list;
};

namespace {

constexpr VkDeviceSize kBlockSize = VkDeviceSize{16} << 20;

}  // namespace

Allocation::Allocation(Allocation&& other) noexcept
    : block_(std::move(other.block_)), offset_(other.offset_), size_(other.size_) {}

Allocation& Allocation::operator=(Allocation&& other) noexcept {
  std::swap(block_, other.block_);
  std::swap(offset_, other.offset_);
  std::swap(size_, other.size_);
  return *this;
}

Allocation::~Allocation() {
  if (block_) block_->list.give_back(offset_, size_);
}

VkDeviceMemory Allocation::memory() const {
  return block_->memory;
}

std::byte* Allocation::mapped() const {
  return block_->mapped == nullptr ? nullptr : block_->mapped + offset_;
}

Memory::Memory(VkPhysicalDevice physical, VkDevice device) : device_(device) {
  vkGetPhysicalDeviceMemoryProperties(physical, &properties_);
}

Memory::~Memory() = default;

std::uint32_t Memory::type_for(std::uint32_t allowed, Place place) const {
  // Best first; the last row of each is what every driver has (Vulkan 1.3, 11.2.1).
  constexpr VkMemoryPropertyFlags mapped =
      VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
  const std::array<std::array<VkMemoryPropertyFlags, 2>, 3> wishes = {{
      {VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, 0},
      {mapped | VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, mapped},
      {mapped | VK_MEMORY_PROPERTY_HOST_CACHED_BIT, mapped},
  }};
  for (const VkMemoryPropertyFlags wish : wishes[static_cast<std::size_t>(place)]) {
    for (std::uint32_t type = 0; type < properties_.memoryTypeCount; ++type) {
      const bool fits = (properties_.memoryTypes[type].propertyFlags & wish) == wish;
      if ((allowed >> type & 1U) != 0 && fits) return type;
    }
  }
  throw Failure(
      "The graphics device has no memory of the kind that Fulcrum needs; choose another one with --gpu.");
}

std::shared_ptr<Allocation::Block> Memory::new_block(std::uint32_t type, VkDeviceSize size, bool image,
                                                     bool map) {
  auto block = std::make_shared<Allocation::Block>(device_, size);
  block->type = type;
  block->image = image;
  VkMemoryAllocateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
  info.allocationSize = size;
  info.memoryTypeIndex = type;
  check(vkAllocateMemory(device_, &info, nullptr, &block->memory), "allocate memory on the graphics device");
  if (map) {
    void* address = nullptr;
    check(vkMapMemory(device_, block->memory, 0, VK_WHOLE_SIZE, 0, &address),
          "map memory of the graphics device");
    block->mapped = static_cast<std::byte*>(address);
  }
  return block;
}

Allocation Memory::allocate(const VkMemoryRequirements& needs, Place place, bool image) {
  const std::uint32_t type = type_for(needs.memoryTypeBits, place);
  const bool map = place != Place::device;
  std::erase_if(blocks_, [](const auto& block) { return block.expired(); });

  Allocation made;
  made.size_ = needs.size;
  for (const auto& known : blocks_) {
    const std::shared_ptr<Allocation::Block> block = known.lock();
    if (block->type != type || block->image != image || (block->mapped != nullptr) != map) continue;
    if (const auto offset = block->list.take(needs.size, needs.alignment)) {
      made.block_ = block;
      made.offset_ = *offset;
      return made;
    }
  }
  // A large one gets a block of its own size: nothing is left over, and it is freed with its only user.
  const VkDeviceSize size = needs.size > kBlockSize / 2 ? needs.size : kBlockSize;
  made.block_ = new_block(type, size, image, map);
  made.offset_ = *made.block_->list.take(needs.size, needs.alignment);
  blocks_.push_back(made.block_);
  return made;
}

}  // namespace fulcrum::vulkan
