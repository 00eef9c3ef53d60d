#pragma once
// Reads a trace.csv line by line.

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/files/line_reader.h"
#include "haptics/math/result.h"

namespace fulcrum::record {

std::vector<std::string_view> split_cells(std::string_view line);

class TraceReader {
public:
  static Result<TraceReader> open(const std::filesystem::path& path);

  const std::vector<std::string>& names() const { return names_; }  // of the columns
  std::optional<std::size_t> column(std::string_view name) const;

  // The next row. False: there is none. A last line without its end was cut off, and is not a row. The cells
  // are valid until the next call. Or it cannot be read, and fault() says why.
  bool next();
  std::span<const std::string_view> cells() const { return cells_; }  // may be more or fewer than names()
  std::size_t line() const { return lines_.line(); }                  // in the file, from 1
  bool complete() const { return complete_; }  // after the last row: the file ended with a whole line
  std::optional<Error> fault() const;

private:
  TraceReader(RegularFile file, std::filesystem::path path)
      : lines_(std::move(file)), path_(std::move(path)) {}
  std::optional<std::string_view> next_line();

  LineReader lines_;
  std::filesystem::path path_;
  std::vector<std::string> names_;
  std::vector<std::string_view> cells_;
  bool complete_ = true;
};

}  // namespace fulcrum::record
