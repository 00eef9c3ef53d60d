#include "engine/record/trace_reader.h"

#include <algorithm>

#include "engine/files/file_error.h"

namespace fulcrum::record {

std::vector<std::string_view> split_cells(std::string_view line) {
  while (line.ends_with('\n') || line.ends_with('\r')) line.remove_suffix(1);
  std::vector<std::string_view> cells;
  for (std::size_t start = 0; start <= line.size();) {
    const std::size_t end = std::min(line.find(',', start), line.size());
    cells.push_back(line.substr(start, end - start));
    start = end + 1;
  }
  return cells;
}

Result<TraceReader> TraceReader::open(const std::filesystem::path& path) {
  Result<RegularFile> file = RegularFile::open(path);
  if (!file) return read_error(path, file.error());
  TraceReader reader(std::move(*file), path);
  if (const std::optional<std::string_view> header = reader.next_line())
    for (const std::string_view name : split_cells(*header)) reader.names_.emplace_back(name);
  if (const std::optional<Error> fault = reader.fault()) return *fault;
  return reader;
}

std::optional<std::size_t> TraceReader::column(std::string_view name) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  return found == names_.end() ? std::nullopt
                               : std::optional(static_cast<std::size_t>(found - names_.begin()));
}

bool TraceReader::next() {
  const std::optional<std::string_view> line = next_line();
  if (line) cells_ = split_cells(*line);
  return line.has_value();
}

std::optional<Error> TraceReader::fault() const {
  if (!lines_.fault()) return std::nullopt;
  return Error{path_.string() + ": " + lines_.fault()->sentence +
               ". Name a trace.csv as a run writes it, or cut the file off before that line."};
}

std::optional<std::string_view> TraceReader::next_line() {
  const std::optional<std::string_view> line = lines_.next();
  complete_ = complete_ && !lines_.fault() && lines_.ended();
  return complete_ ? line : std::nullopt;
}

}  // namespace fulcrum::record
