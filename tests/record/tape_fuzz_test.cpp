// Reference: none; any bytes at all. Invariants: reading neither crashes nor allocates out of proportion to
// the bytes there are, and gives either a sentence or entries that the bytes have room for. Half of the
// damage is done beneath checksums that fit again, so that it reaches what lies behind them.
#include <gtest/gtest.h>

#include <algorithm>

#include "engine/record/tape_reader.h"
#include "engine/record/tape_writer.h"
#include "synthetic_run.h"
#include "tape_checksums.h"

namespace fulcrum::record {
namespace {

std::string small_tape() {
  const TemporaryFolder folder;
  Result<TapeWriter> writer = TapeWriter::create(folder / "tape", made_up_header());
  SyntheticRun made_up(1);
  const Command stop{Command::Kind::stop};
  for (int i = 0; i < 12; ++i) {
    writer->entry(made_up.sample(), std::span(&stop, i % 2 == 0 ? 1 : 0), 0, 1);
    if (i % 4 == 3) EXPECT_FALSE(writer->flush());
  }
  EXPECT_FALSE(writer->finish());
  return contents(folder / "tape");
}

void damage(std::string& text, std::mt19937_64& random) {
  const std::size_t at = random() % text.size();
  const std::size_t run = std::min<std::size_t>(1 + random() % 16, text.size() - at);
  switch (random() % 6) {
    case 0:
      text[at] = static_cast<char>(random());
      break;
    case 1:  // numbers that sizes and counts go wrong with
      for (std::size_t i = at; i < std::min(at + 4, text.size()); ++i)
        text[i] = random() % 2 == 0 ? '\xff' : '\x7f';
      break;
    case 2:
      text.erase(at, run);
      break;
    case 3:
      text.insert(at, std::string(text, random() % text.size(), run));
      break;
    case 4:
      text.resize(at);
      break;
    default:
      text.insert(at, std::string(run, static_cast<char>(random())));
      break;
  }
  if (text.empty()) text.push_back('F');
}

TEST(TapeFuzz, AnyBytesGiveASentenceOrATape) {
  const std::string original = small_tape();
  std::mt19937_64 random(20250601);
  int read = 0, refused = 0, mended_and_refused = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string text = original;
    for (std::uint64_t n = 1 + random() % 4; n > 0; --n) damage(text, random);
    const bool mended = random() % 2 == 0;
    if (mended) mend_checksums(text);
    const Result<Tape> tape = parse_tape(bytes_of(text));
    if (!tape) {
      EXPECT_FALSE(tape.error().sentence.empty());
      ++refused;
      mended_and_refused += mended ? 1 : 0;
      continue;
    }
    ++read;
    EXPECT_LE(tape->entries.size() * 97, text.size());
    EXPECT_LE(tape->entries.capacity(), 2 * text.size() / 97 + 1);
  }
  // The damage is of use only if it gets both past the checksums and stopped behind them.
  EXPECT_GT(read, 500);
  EXPECT_GT(refused, 500);
  EXPECT_GT(mended_and_refused, 500);
}

TEST(TapeFuzz, GarbageBehindTheMagicIsRefused) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 5000; ++i) {
    std::string text("FULCTAPE\3\0\0\0", 12);
    const std::size_t size = random() % 300;
    for (std::size_t j = 0; j < size; ++j) text += static_cast<char>(random());
    if (i % 2 == 0) mend_checksums(text);
    EXPECT_FALSE(parse_tape(bytes_of(text)));
  }
}

TEST(TapeFuzz, AHeaderNestedWithoutEndIsRefused) {
  std::string text("FULCTAPE\3\0\0\0", 12);
  const std::string json(200'000, '[');
  const auto size = static_cast<std::uint32_t>(json.size());
  text.append(reinterpret_cast<const char*>(&size), 4);
  text += "crc1" + json + "crc2";
  mend_checksums(text);
  EXPECT_FALSE(parse_tape(bytes_of(text)));
}

}  // namespace
}  // namespace fulcrum::record
