#include "engine/session/identity.h"

#include <array>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <random>

#include "engine/files/utf8.h"

namespace fulcrum::session {
namespace {

constexpr std::size_t kMostLetters = 64;

// The code point that begins there, of valid UTF-8; moves on to the next.
char32_t next_letter(std::string_view text, std::size_t& at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(at++);
  if (first < 0x80) return first;
  const int more = first >= 0xf0 ? 3 : first >= 0xe0 ? 2 : 1;
  char32_t letter = first & (0x3fU >> more);
  for (int i = 0; i < more; ++i) letter = (letter << 6U) | (byte(at++) & 0x3fU);
  return letter;
}

// Control characters, spaces other than the plain one, marks of direction, joiners, private use: two names
// that look alike would be two people.
bool is_unseen(char32_t c) {
  return c < 0x20 || (c >= 0x7f && c <= 0xa0) || c == 0xad || c == 0x34f || c == 0x61c || c == 0x1680 ||
         (c >= 0x115f && c <= 0x1160) || (c >= 0x17b4 && c <= 0x17b5) || (c >= 0x180b && c <= 0x180f) ||
         (c >= 0x2000 && c <= 0x200f) || (c >= 0x2028 && c <= 0x202f) || (c >= 0x205f && c <= 0x206f) ||
         c == 0x2800 || c == 0x3000 || c == 0x3164 || (c >= 0xe000 && c <= 0xf8ff) ||
         (c >= 0xfe00 && c <= 0xfe0f) || c == 0xfeff || c == 0xffa0 || (c >= 0xfff0 && c <= 0xffff) ||
         c >= 0xe0000;
}

// On top of the letter before: one letter may be written with such a mark, or as one.
bool is_mark(char32_t c) {
  return (c >= 0x300 && c <= 0x36f) || (c >= 0x1ab0 && c <= 0x1aff) || (c >= 0x1dc0 && c <= 0x1dff) ||
         (c >= 0x20d0 && c <= 0x20ff) || (c >= 0xfe20 && c <= 0xfe2f);
}

bool may_begin(char32_t c) {
  return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
         (c > 0xbf && c != 0xd7 && c != 0xf7 && !(c >= 0xff01 && c <= 0xff0f) &&
          !(c >= 0xff1a && c <= 0xff20));
}

}  // namespace

std::optional<Error> refuse_pseudonym(std::string_view name) {
  if (name.empty()) return Error{"A participant's name is empty: give a pseudonym, such as P07."};
  if (utf8_bytes(name) != name.size())
    return Error{"A participant's name is not UTF-8: give a pseudonym, such as P07."};
  std::size_t letters = 0;
  for (std::size_t at = 0; at < name.size(); ++letters) {
    const bool first = at == 0;
    const char32_t letter = next_letter(name, at);
    if (is_unseen(letter))
      return Error{
          "A participant's name holds a character that nobody sees: give a plain pseudonym, such as P07."};
    if (is_mark(letter))
      return Error{
          "A participant's name writes a letter and its accent as two characters: type it as one, or give a "
          "plain pseudonym, such as P07."};
    if (first && !may_begin(letter))
      return Error{"A participant's name begins with a letter or a digit: give a pseudonym, such as P07."};
  }
  if (name.back() == ' ') return Error{"A participant's name ends with a space: leave it out."};
  if (letters > kMostLetters)
    return Error{"A participant's name has " + std::to_string(letters) + " letters, and may have " +
                 std::to_string(kMostLetters) + ": shorten it."};
  return std::nullopt;
}

std::string random_uuid() {
  std::random_device source;
  std::array<std::uint32_t, 4> word{};
  for (std::uint32_t& w : word) w = source();
  word[1] = (word[1] & 0xffff0fffU) | 0x00004000U;
  word[2] = (word[2] & 0x3fffffffU) | 0x80000000U;
  char text[40];
  std::snprintf(text, sizeof text, "%08x-%04x-%04x-%04x-%04x%08x", word[0], word[1] >> 16U, word[1] & 0xffffU,
                word[2] >> 16U, word[2] & 0xffffU, word[3]);
  return text;
}

std::string utc_text(std::chrono::system_clock::time_point time) {
  const auto since = std::chrono::duration_cast<std::chrono::milliseconds>(time.time_since_epoch()).count();
  const std::time_t seconds = since / 1000;
  std::tm parts{};
  gmtime_r(&seconds, &parts);
  char date[32], text[48];
  const std::size_t length = std::strftime(date, sizeof date, "%Y-%m-%dT%H:%M:%S", &parts);
  std::snprintf(text, sizeof text, "%.*s.%03dZ", static_cast<int>(length), date,
                static_cast<int>(since % 1000));
  return text;
}

}  // namespace fulcrum::session
