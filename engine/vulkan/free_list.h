#pragma once
// Which parts of one block of memory are free. Knows numbers only, no Vulkan.

#include <cstdint>
#include <map>
#include <optional>

namespace fulcrum::vulkan {

class FreeList {
public:
  explicit FreeList(std::uint64_t size) : free_{{0, size}} {}

  // Takes the lowest place that fits; nothing where none does. The alignment is a power of two.
  std::optional<std::uint64_t> take(std::uint64_t size, std::uint64_t alignment);

  // Gives back what take() returned for this size, and joins it to its free neighbours.
  void give_back(std::uint64_t offset, std::uint64_t size);

private:
  std::map<std::uint64_t, std::uint64_t> free_;  // offset -> size, no two touch
};

}  // namespace fulcrum::vulkan
