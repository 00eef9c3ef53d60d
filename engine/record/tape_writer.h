#pragma once
// Writes a tape while the run goes on.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "engine/files/block_file.h"
#include "engine/record/tape.h"
#include "haptics/math/result.h"

namespace fulcrum::record {

class TapeWriter {
public:
  // Makes the file, with its header.
  static Result<TapeWriter> create(const std::filesystem::path& path, const TapeHeader& header);

  void entry(const DeviceSample& sample, std::span<const Command> commands, std::int64_t lost_before,
             std::uint64_t digest);

  // Brings the pending entries to the file, as one chunk. After an error the file ends with the chunk before,
  // and the pending ones are dropped.
  std::optional<Error> flush();
  // The end chunk: the run ended and every entry is there. Flush first.
  std::optional<Error> finish();

private:
  explicit TapeWriter(BlockFile file) : file_(std::move(file)) {}
  std::optional<Error> append_chunk(std::uint32_t kind, std::string_view payload);

  BlockFile file_;
  std::string pending_;  // entries without the chunk around them
  std::uint32_t pending_entries_ = 0;
  std::uint64_t entries_ = 0;  // in the file
};

}  // namespace fulcrum::record
