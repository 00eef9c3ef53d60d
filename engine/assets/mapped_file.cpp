#include "engine/assets/mapped_file.h"

#include <sys/mman.h>

#include <utility>

#include "engine/files/regular_file.h"

namespace fulcrum {

std::optional<MappedFile> MappedFile::open(const std::filesystem::path& path) {
  const Result<RegularFile> file = RegularFile::open(path);
  if (!file) return std::nullopt;
  const auto size = static_cast<std::size_t>(file->size());
  void* const at = size > 0
                       ? ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE | MAP_POPULATE, file->descriptor(), 0)
                       : nullptr;
  if (at == MAP_FAILED) return std::nullopt;
  return MappedFile({static_cast<const std::byte*>(at), size});
}

MappedFile::~MappedFile() {
  if (!bytes_.empty()) ::munmap(const_cast<std::byte*>(bytes_.data()), bytes_.size());
}

MappedFile::MappedFile(MappedFile&& other) noexcept : bytes_(std::exchange(other.bytes_, {})) {}

}  // namespace fulcrum
