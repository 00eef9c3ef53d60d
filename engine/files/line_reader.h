#pragma once
// A file's lines, one at a time, in memory that does not grow with the file.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "engine/files/regular_file.h"

namespace fulcrum {

class LineReader {
public:
  static constexpr std::size_t kLongest = std::size_t{1} << 16;  // bytes; the widest trace has some 5000

  explicit LineReader(RegularFile file) : file_(std::move(file)) {}

  // The next line without its end, valid until the next call; nothing after the last one, or where fault()
  // has something.
  std::optional<std::string_view> next();
  std::size_t line() const { return line_; }  // the number of the last one, from 1
  bool ended() const { return ended_; }       // the last line had an end
  // Why there is no next line, "line 3 is longer than 65536 bytes", if it is not that the file is at its end.
  const std::optional<Error>& fault() const { return fault_; }

private:
  bool fill();

  RegularFile file_;
  std::string buffer_;  // [at_, size) is still to be given
  std::size_t at_ = 0;
  std::size_t line_ = 0;
  bool ended_ = true;
  bool at_end_ = false;
  std::optional<Error> fault_;
};

}  // namespace fulcrum
