#pragma once
// Writes timing.csv: what the real clock said, kept apart so that trace.csv is the same in every run.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "engine/files/block_file.h"
#include "haptics/math/result.h"

namespace fulcrum::record {

struct TickTiming {
  std::int64_t tick = 0;
  std::int64_t cpu_ns = 0;        // processor time of the tick
  std::int64_t wake_late_ns = 0;  // how long after its due time it began; 0 offline
  std::int64_t lost_before = 0;   // ticks lost to an overrun before this one
};

class TimingWriter {
public:
  static Result<TimingWriter> create(const std::filesystem::path& path);

  void row(const TickTiming& timing);
  std::optional<Error> flush();
  void take_back() { file_.take_back(); }
  std::optional<Error> close() { return file_.close(); }

private:
  explicit TimingWriter(BlockFile file) : file_(std::move(file)) {}

  BlockFile file_;
  std::string pending_;
};

}  // namespace fulcrum::record
