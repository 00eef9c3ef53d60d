#include "engine/files/number_text.h"

#include <charconv>
#include <cmath>

namespace fulcrum {

void append_number(std::string& to, double value) {
  if (std::isnan(value)) {
    to += "nan";
    return;
  }
  char text[32];  // the longest, -2.2250738585072014e-308, has 24
  const double unsigned_zero = value == 0 ? 0.0 : value;
  to.append(text, std::to_chars(std::begin(text), std::end(text), unsigned_zero).ptr);
}

void append_number(std::string& to, std::int64_t value) {
  char text[24];  // -9223372036854775808 has 20
  to.append(text, std::to_chars(std::begin(text), std::end(text), value).ptr);
}

}  // namespace fulcrum
