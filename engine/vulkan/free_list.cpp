#include "engine/vulkan/free_list.h"

#include <iterator>

namespace fulcrum::vulkan {

std::optional<std::uint64_t> FreeList::take(std::uint64_t size, std::uint64_t alignment) {
  for (auto hole = free_.begin(); hole != free_.end(); ++hole) {
    const auto [start, length] = *hole;
    const std::uint64_t offset = (start + alignment - 1) & ~(alignment - 1);
    if (offset + size > start + length) continue;
    free_.erase(hole);
    if (offset > start) free_.emplace(start, offset - start);
    if (offset + size < start + length) free_.emplace(offset + size, start + length - offset - size);
    return offset;
  }
  return std::nullopt;
}

void FreeList::give_back(std::uint64_t offset, std::uint64_t size) {
  auto next = free_.lower_bound(offset);
  if (next != free_.end() && next->first == offset + size) {
    size += next->second;
    next = free_.erase(next);
  }
  if (next != free_.begin()) {
    const auto before = std::prev(next);
    if (before->first + before->second == offset) {
      before->second += size;
      return;
    }
  }
  free_.emplace(offset, size);
}

}  // namespace fulcrum::vulkan
