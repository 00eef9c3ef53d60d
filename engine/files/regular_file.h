#pragma once
// A file that a person, a scenario or a model names, open for reading. Nothing else opens such a file: pipes,
// sockets, devices and folders are refused before they are opened, so that no name can make the program wait
// or act.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

#include "haptics/math/result.h"

namespace fulcrum {

class RegularFile {
public:
  // Errors are clauses that the caller's sentence ends in: "No such file or directory", "it is a pipe, not a
  // file".

  // What a person typed may lie anywhere.
  static Result<RegularFile> open(const std::filesystem::path& path);

  // What a scenario or a model names lies in its folder: '..' and links are followed, and where they have led
  // is what counts. A path that is not absolute begins in the folder.
  static Result<RegularFile> open_within(const std::filesystem::path& folder,
                                         const std::filesystem::path& path);

  RegularFile(RegularFile&& other) noexcept;
  RegularFile& operator=(RegularFile&&) = delete;
  ~RegularFile();

  // At most `most` bytes of it, from its beginning. Asking for one byte more than is of use tells a file that
  // is too large, and no file fills the memory.
  Result<std::string> first_bytes(std::uint64_t most) const;
  // The next bytes into [to, to + size); how many there were, 0 at the end.
  Result<std::size_t> read_on(char* to, std::size_t size);

  std::uint64_t size() const { return size_; }  // bytes, when it was opened
  int descriptor() const { return descriptor_; }

private:
  RegularFile(int descriptor, std::uint64_t size) : descriptor_(descriptor), size_(size) {}
  static Result<RegularFile> open_handle(int handle);  // made with O_PATH

  int descriptor_ = -1;
  std::uint64_t size_ = 0;
};

}  // namespace fulcrum
