#pragma once
// Reads a trace.csv line by line.

#include <filesystem>
#include <fstream>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "haptics/math/result.h"

namespace fulcrum::record {

std::vector<std::string_view> split_cells(std::string_view line);

class TraceReader {
public:
  static Result<TraceReader> open(const std::filesystem::path& path);

  const std::vector<std::string>& names() const { return names_; }  // of the columns
  std::optional<std::size_t> column(std::string_view name) const;

  // The next row. False: there is none. A last line without its end was cut off, and is not a row. The cells
  // are valid until the next call.
  bool next();
  std::span<const std::string_view> cells() const { return cells_; }  // may be more or fewer than names()
  std::size_t line() const { return line_; }                          // in the file, from 1
  bool complete() const { return complete_; }  // after the last row: the file ended with a whole line

private:
  bool read_line();

  std::ifstream file_;
  std::string text_;
  std::vector<std::string> names_;
  std::vector<std::string_view> cells_;
  std::size_t line_ = 0;
  bool complete_ = true;
};

}  // namespace fulcrum::record
