#include "engine/record/trace_reader.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <system_error>

#include "engine/record/file_error.h"

namespace fulcrum::record {

std::vector<std::string_view> split_cells(std::string_view line) {
  while (line.ends_with('\n') || line.ends_with('\r')) {
    line.remove_suffix(1);
  }
  std::vector<std::string_view> cells;
  for (std::size_t start = 0; start <= line.size();) {
    const std::size_t end = std::min(line.find(',', start), line.size());
    cells.push_back(line.substr(start, end - start));
    start = end + 1;
  }
  return cells;
}

Result<TraceReader> TraceReader::open(const std::filesystem::path& path) {
  std::error_code failure;
  // What has no size, a device, would be read without end.
  if (std::filesystem::file_size(path, failure) == static_cast<std::uintmax_t>(-1)) {
    return file_error("read", path, failure.value());
  }
  TraceReader reader;
  reader.file_.open(path, std::ios::binary);
  if (!reader.file_) {
    return file_error("read", path, errno);
  }
  if (reader.read_line()) {
    for (const std::string_view name : split_cells(reader.text_)) {
      reader.names_.emplace_back(name);
    }
  }
  return reader;
}

std::optional<std::size_t> TraceReader::column(std::string_view name) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  return found == names_.end() ? std::nullopt
                               : std::optional(static_cast<std::size_t>(found - names_.begin()));
}

bool TraceReader::next() {
  if (!read_line()) {
    return false;
  }
  cells_ = split_cells(text_);
  return true;
}

bool TraceReader::read_line() {
  if (!std::getline(file_, text_)) {
    return false;
  }
  if (file_.eof()) {
    complete_ = false;
    return false;
  }
  ++line_;
  return true;
}

}  // namespace fulcrum::record
