#pragma once
// Samples as a WAV file: 16 bit, a header of 44 bytes (IBM and Microsoft, "Multimedia Programming Interface
// and Data Specifications 1.0", RIFF WAVE).
//
// It is written block by block, and after each the header is set right again: a run that is killed leaves a
// file that players open, with all blocks but the last.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "engine/files/block_file.h"
#include "haptics/math/result.h"

namespace fulcrum::record {

class WavWriter {
public:
  // Makes the file, with the header of no samples.
  static Result<WavWriter> create(const std::filesystem::path& path, std::uint32_t rate_Hz,
                                  std::uint32_t channels = 1);

  // From -1 to 1; what is beyond is cut off there. Of several channels, frame by frame, each frame whole.
  void add(std::span<const double> samples);

  // Brings what was added to the file. After an error it ends with the block before, and what was added is
  // dropped.
  std::optional<Error> flush();
  // Drops the block of the last flush, which succeeded; once.
  void take_back();
  std::optional<Error> close() { return file_.close(); }

private:
  WavWriter(BlockFile file, std::uint32_t rate_Hz, std::uint32_t channels)
      : file_(std::move(file)), rate_Hz_(rate_Hz), channels_(channels) {}

  BlockFile file_;
  std::uint32_t rate_Hz_, channels_;
  std::uint32_t samples_ = 0;   // in the file
  std::uint32_t previous_ = 0;  // in the file before the last block
  std::string pending_;
};

}  // namespace fulcrum::record
