#include "engine/files/plain_text.h"

#include <algorithm>
#include <cstdint>

#include "engine/files/utf8.h"

namespace fulcrum {
namespace {

constexpr std::string_view kReplacement = "\xef\xbf\xbd";  // U+FFFD

// How many bytes the character has that `text` begins with, if it must not be shown; 0: it may be.
std::size_t unshown_bytes(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<std::uint8_t>(text[i]) : 0; };
  const auto within = [](int value, int first, int last) { return value >= first && value <= last; };
  if (byte(0) < 0x20 || byte(0) == 0x7f) return 1;
  if (byte(0) == 0xc2 && within(byte(1), 0x80, 0x9f))
    return 2;  // U+0080 to U+009F: a terminal obeys these, too
  if (byte(0) != 0xe2) return 0;
  const bool line_or_direction = byte(1) == 0x80 && within(byte(2), 0xa8, 0xae);  // U+2028 to U+202E
  const bool isolate = byte(1) == 0x81 && within(byte(2), 0xa6, 0xa9);            // U+2066 to U+2069
  return line_or_direction || isolate ? 3 : 0;
}

void append_shown(std::string& to, std::string_view utf8) {
  while (!utf8.empty()) {
    const std::size_t unshown = unshown_bytes(utf8);
    to += unshown == 0 ? utf8.front() : ' ';
    utf8.remove_prefix(std::max<std::size_t>(unshown, 1));
  }
}

}  // namespace

std::string plain_text(std::string_view text) {
  std::string plain;
  while (!text.empty()) {
    const std::size_t good = utf8_bytes(text);
    append_shown(plain, text.substr(0, good));
    text.remove_prefix(good);
    if (text.empty()) break;
    plain += kReplacement;
    text.remove_prefix(1);
  }
  return plain;
}

std::string short_text(std::string_view text, std::size_t most) {
  std::string plain = plain_text(text.substr(0, most));
  if (text.size() <= most && plain.size() <= most) return plain;
  plain.resize(std::min(plain.size(), most));
  plain.resize(utf8_bytes(plain));  // a character that was cut goes whole
  return plain + "...";
}

}  // namespace fulcrum
