#include "engine/files/line_reader.h"

#include <algorithm>

namespace fulcrum {

std::optional<std::string_view> LineReader::next() {
  if (fault_) return std::nullopt;
  std::size_t searched = 0;
  for (;;) {
    const std::string_view left = std::string_view(buffer_).substr(at_);
    const std::size_t end = left.find('\n', searched);
    if (std::min(end, left.size()) > kLongest) {
      fault_ = Error{"line " + std::to_string(line_ + 1) + " is longer than " + std::to_string(kLongest) +
                     " bytes"};
      return std::nullopt;
    }
    if (end != left.npos || (at_end_ && !left.empty())) {
      ++line_;
      ended_ = end != left.npos;
      at_ += ended_ ? end + 1 : left.size();
      return left.substr(0, end);
    }
    if (at_end_) return std::nullopt;
    searched = left.size();
    if (!fill()) return std::nullopt;
  }
}

// Moves what is left to the front and reads on behind it.
bool LineReader::fill() {
  buffer_.erase(0, at_);
  at_ = 0;
  const std::size_t size = buffer_.size();
  buffer_.resize(size + kLongest);
  const Result<std::size_t> got = file_.read_on(buffer_.data() + size, kLongest);
  buffer_.resize(size + (got ? *got : 0));
  if (!got) fault_ = got.error();
  at_end_ = got && *got == 0;
  return static_cast<bool>(got);
}

}  // namespace fulcrum
