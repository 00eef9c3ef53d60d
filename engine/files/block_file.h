#pragma once
// A new file that grows by whole blocks: after any failure it ends where a block ends.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>

#include "haptics/math/result.h"

namespace fulcrum {

class BlockFile {
public:
  // Fails if something of this name is there already.
  static Result<BlockFile> create(const std::filesystem::path& path);

  // Takes over an open descriptor at its end; path: what to call it in a sentence.
  BlockFile(int descriptor, std::filesystem::path path) : descriptor_(descriptor), path_(std::move(path)) {}
  BlockFile(BlockFile&& other) noexcept;
  BlockFile& operator=(BlockFile&& other) noexcept;
  ~BlockFile();

  // All of it or nothing.
  std::optional<Error> append(std::string_view block);
  // Cuts off what the last append() added; once.
  void take_back();
  // In place of the first bytes, which are there already: as many as `head` has.
  std::optional<Error> overwrite_head(std::string_view head) const;
  // Some file systems tell of a failed write only here.
  std::optional<Error> close();

private:
  void cut(std::uint64_t size) const;

  int descriptor_ = -1;
  std::filesystem::path path_;
  std::uint64_t size_ = 0;           // bytes
  std::uint64_t previous_size_ = 0;  // bytes, before the last block
};

// A new file of this content; where it cannot be written to its end, none.
std::optional<Error> write_new_file(const std::filesystem::path& path, std::string_view content);

}  // namespace fulcrum
