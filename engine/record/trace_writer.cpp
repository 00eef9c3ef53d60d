#include "engine/record/trace_writer.h"

#include <utility>

namespace fulcrum::record {

Result<TraceWriter> TraceWriter::create(const std::filesystem::path& path, TraceColumns columns) {
  Result<BlockFile> file = BlockFile::create(path);
  if (!file) return file.error();
  TraceWriter writer(std::move(*file), std::move(columns));
  writer.pending_ = writer.columns_.header();
  if (std::optional<Error> error = writer.flush()) return *std::move(error);
  return writer;
}

std::optional<Error> TraceWriter::flush() {
  sha_.update(flushed_);
  flushed_.swap(pending_);
  pending_.clear();
  std::optional<Error> error = file_.append(flushed_);
  if (error) flushed_.clear();
  return error;
}

void TraceWriter::take_back() {
  file_.take_back();
  flushed_.clear();
}

std::string TraceWriter::sha256_hex() {
  sha_.update(flushed_);
  flushed_.clear();
  return sha_.finish_hex();
}

}  // namespace fulcrum::record
