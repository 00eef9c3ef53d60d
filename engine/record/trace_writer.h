#pragma once
// Writes trace.csv, and names its content by SHA-256 on the way.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "engine/assets/sha256.h"
#include "engine/files/block_file.h"
#include "engine/record/trace_columns.h"
#include "haptics/math/result.h"

namespace fulcrum::record {

class TraceWriter {
public:
  // Makes the file, with its header line.
  static Result<TraceWriter> create(const std::filesystem::path& path, TraceColumns columns);

  void row(const TraceRow& row) { columns_.append_row(pending_, row); }
  std::size_t pending_bytes() const { return pending_.size(); }

  // Brings the pending rows to the file. After an error the file ends with the rows of the flush before, and
  // the pending ones are dropped.
  std::optional<Error> flush();
  // Drops the rows of the last flush, which succeeded; once.
  void take_back();
  // Of the file as it lies there; nothing can be written afterwards.
  std::string sha256_hex();
  std::optional<Error> close() { return file_.close(); }

private:
  TraceWriter(BlockFile file, TraceColumns columns) : file_(std::move(file)), columns_(std::move(columns)) {}

  BlockFile file_;
  TraceColumns columns_;
  Sha256 sha_;           // of the file without flushed_
  std::string flushed_;  // the last block, which may yet be taken back
  std::string pending_;
};

}  // namespace fulcrum::record
