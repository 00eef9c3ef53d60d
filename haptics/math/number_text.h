#pragma once
// Numbers in sentences.

#include <charconv>
#include <string>

namespace fulcrum {

// value with `digits` significant digits, in the C locale.
inline std::string number_text(double value, int digits = 4) {
  char text[40];
  const auto [end, error] =
      std::to_chars(text, text + sizeof text, value, std::chars_format::general, digits);
  return error == std::errc() ? std::string(text, end) : std::string("?");
}

}  // namespace fulcrum
