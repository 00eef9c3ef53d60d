// Reference: none; any bytes at all. Invariants: reading a tape neither crashes nor goes out of bounds, and
// gives a sentence, or entries that the bytes have room for.
//
// Checksums are made to fit, unless the first byte is odd, so that the damage gets behind them.

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>

#include "engine/record/crc32c.h"
#include "engine/record/tape_reader.h"

namespace {

using namespace fulcrum::record;

// Makes the checksum that follows text[at, at + size) fit. False: there is no room for one.
bool mend(std::string& text, std::size_t at, std::size_t size) {
  if (at > text.size() || size > text.size() - at || text.size() - at - size < 4) return false;
  const std::uint32_t crc = crc32c(std::as_bytes(std::span(text).subspan(at, size)));
  std::memcpy(text.data() + at + size, &crc, sizeof crc);
  return true;
}

std::uint32_t word(const std::string& text, std::size_t at) {
  std::uint32_t value = 0;
  std::memcpy(&value, text.data() + at, sizeof value);
  return value;
}

void mend_all(std::string& text) {
  if (!mend(text, 0, 16)) return;
  std::size_t at = 20;
  std::size_t size = word(text, 12);
  while (mend(text, at, size)) {
    at += size + 4;
    if (!mend(text, at, 8)) return;
    size = word(text, at + 4);
    at += 12;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  std::string bytes(reinterpret_cast<const char*>(data + 1), size - 1);
  if (data[0] % 2 == 0) mend_all(bytes);
  const auto tape = parse_tape(std::as_bytes(std::span(bytes)));
  if (!tape) {
    if (!tape.error().sentence.ends_with(".")) std::abort();
  } else if (tape->entries.size() > bytes.size() / 64) {  // an entry has eight numbers and more
    std::abort();
  }
  return 0;
}
