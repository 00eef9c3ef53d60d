#pragma once
// A file's bytes, read where the system keeps them.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>

namespace fulcrum {

class MappedFile {
public:
  // Nothing where the path is no regular file that can be read. An empty file has no bytes.
  static std::optional<MappedFile> open(const std::filesystem::path& path);
  ~MappedFile();
  MappedFile(MappedFile&& other) noexcept;
  MappedFile& operator=(MappedFile&&) = delete;

  std::span<const std::byte> bytes() const { return bytes_; }

private:
  explicit MappedFile(std::span<const std::byte> bytes) : bytes_(bytes) {}
  std::span<const std::byte> bytes_;
};

}  // namespace fulcrum
