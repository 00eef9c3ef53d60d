// Reference: none; any bytes at all. Invariants: reading a tape neither crashes nor goes out of bounds, and
// gives a sentence, or entries that the bytes have room for.
//
// Checksums are made to fit, unless the first byte is odd, so that the damage gets behind them.

#include <cstdint>
#include <cstdlib>
#include <string>

#include "engine/record/tape_reader.h"
#include "tests/record/tape_checksums.h"

using namespace fulcrum::record;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  std::string bytes(reinterpret_cast<const char*>(data + 1), size - 1);
  if (data[0] % 2 == 0) mend_checksums(bytes);
  const auto tape = parse_tape(std::as_bytes(std::span(bytes)));
  if (!tape) {
    if (!tape.error().sentence.ends_with(".")) std::abort();
  } else if (tape->entries.size() > bytes.size() / 64) {  // an entry has eight numbers and more
    std::abort();
  }
  return 0;
}
