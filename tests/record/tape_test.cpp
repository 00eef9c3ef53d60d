// References: what is written is what is read, bit for bit; a tape cut anywhere gives the whole chunks before
// the cut; a tape with any one bit turned is refused.
#include <gtest/gtest.h>

#include <bit>
#include <limits>

#include "engine/record/crc32c.h"
#include "engine/record/tape_reader.h"
#include "engine/record/tape_writer.h"
#include "synthetic_run.h"

namespace fulcrum::record {
namespace {

std::vector<TapeEntry> made_up_entries(int count) {
  SyntheticRun made_up(7);
  std::vector<TapeEntry> entries;
  for (int i = 0; i < count; ++i) {
    TapeEntry& entry = entries.emplace_back();
    entry.sample = made_up.sample();
    entry.lost_before = i % 5 == 0 ? i : 0;
    entry.digest = 0x0123456789abcdefu * static_cast<std::uint64_t>(i + 1);
    if (i % 3 == 0) {
      entry.commands = {{Command::Kind::stop},
                        {Command::Kind::acknowledge},
                        {Command::Kind::ghost_gain, 0.25},
                        {Command::Kind::impact_gain, 0.5},
                        {Command::Kind::pulse_gain, 1},
                        {Command::Kind::last, 1}};
    }
  }
  entries.front().sample.X_DH.p = Vec3(-0.0, std::bit_cast<double>(0x7ff8dead0000beefu), 5e-324);
  return entries;
}

void expect_same(const TapeEntry& read, const TapeEntry& written) {
  const auto bits = [](const DeviceSample& s) {
    return std::array<std::uint64_t, 9>{
        std::bit_cast<std::uint64_t>(s.X_DH.q.w()), std::bit_cast<std::uint64_t>(s.X_DH.q.x()),
        std::bit_cast<std::uint64_t>(s.X_DH.q.y()), std::bit_cast<std::uint64_t>(s.X_DH.q.z()),
        std::bit_cast<std::uint64_t>(s.X_DH.p.x()), std::bit_cast<std::uint64_t>(s.X_DH.p.y()),
        std::bit_cast<std::uint64_t>(s.X_DH.p.z()), std::bit_cast<std::uint64_t>(s.age),
        std::bit_cast<std::uint64_t>(s.strip_ohm)};
  };
  EXPECT_EQ(bits(read.sample), bits(written.sample));
  EXPECT_EQ(read.sample.buttons, written.sample.buttons);
  EXPECT_EQ(read.sample.connected, written.sample.connected);
  EXPECT_EQ(read.commands, written.commands);
  EXPECT_EQ(read.lost_before, written.lost_before);
  EXPECT_EQ(read.digest, written.digest);
}

// A tape of these entries in chunks of four. boundaries: where a chunk ends, the header's end first.
std::string tape_of(const std::vector<TapeEntry>& entries, std::vector<std::size_t>* boundaries = nullptr) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "tape";
  Result<TapeWriter> writer = TapeWriter::create(path, made_up_header());
  const auto note = [&] {
    if (boundaries != nullptr) boundaries->push_back(std::filesystem::file_size(path));
  };
  note();
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const TapeEntry& e = entries[i];
    writer->entry(e.sample, e.commands, e.lost_before, *e.digest);
    if (i % 4 == 3 || i + 1 == entries.size()) {
      EXPECT_FALSE(writer->flush());
      note();
    }
  }
  EXPECT_FALSE(writer->finish());
  return contents(path);
}

TEST(Tape, Crc32cIsTheStandardOne) {  // RFC 3720 B.4, and the check value of the catalogue of CRCs
  EXPECT_EQ(crc32c(bytes_of("123456789")), 0xe3069283u);
  EXPECT_EQ(crc32c(bytes_of(std::string(32, '\0'))), 0x8a9136aau);
}

TEST(Tape, ReadsBackWhatWasWritten) {
  const std::vector<TapeEntry> entries = made_up_entries(30);
  const Result<Tape> tape = parse_tape(bytes_of(tape_of(entries)));
  ASSERT_TRUE(tape) << tape.error().sentence;
  EXPECT_EQ(tape->header, made_up_header());
  EXPECT_TRUE(tape->complete);
  ASSERT_EQ(tape->entries.size(), entries.size());
  for (std::size_t i = 0; i < entries.size(); ++i) expect_same(tape->entries[i], entries[i]);
}

TEST(Tape, CutAnywhereGivesTheWholeChunks) {
  const std::vector<TapeEntry> entries = made_up_entries(10);
  std::vector<std::size_t> boundaries;
  const std::string text = tape_of(entries, &boundaries);
  for (std::size_t size = 0; size < text.size(); ++size) {
    const Result<Tape> tape = parse_tape(bytes_of(text).first(size));
    if (size < boundaries.front()) {
      ASSERT_FALSE(tape) << size;
      continue;
    }
    ASSERT_TRUE(tape) << size << ": " << tape.error().sentence;
    EXPECT_FALSE(tape->complete) << size;
    std::size_t chunks = 0;
    while (chunks + 1 < boundaries.size() && boundaries[chunks + 1] <= size) ++chunks;
    ASSERT_EQ(tape->entries.size(), std::min<std::size_t>(4 * chunks, entries.size())) << size;
    for (std::size_t i = 0; i < tape->entries.size(); ++i) expect_same(tape->entries[i], entries[i]);
  }
}

TEST(Tape, AnyTurnedBitIsRefused) {
  const std::string text = tape_of(made_up_entries(6));
  for (std::size_t i = 0; i < text.size(); ++i) {
    for (int bit = 0; bit < 8; ++bit) {
      std::string turned = text;
      turned[i] = static_cast<char>(turned[i] ^ (1 << bit));
      const Result<Tape> tape = parse_tape(bytes_of(turned));
      ASSERT_FALSE(tape) << "byte " << i << " bit " << bit;
      EXPECT_NE(tape.error().sentence.find("byte "), std::string::npos) << tape.error().sentence;
    }
  }
}

TEST(Tape, OtherVersionsAreNamed) {
  std::string text = tape_of(made_up_entries(1));
  text[8] = 5;
  const Result<Tape> tape = parse_tape(bytes_of(text));
  ASSERT_FALSE(tape);
  EXPECT_NE(tape.error().sentence.find("format version 5 (byte 8), and this program reads 2 to 4"),
            std::string::npos)
      << tape.error().sentence;
}

// Version 2 had no strip: its entries are 8 bytes shorter, after the age.
TEST(Tape, OfVersion2IsStillRead) {
  std::vector<TapeEntry> entries = made_up_entries(2);
  entries.erase(entries.begin());
  std::vector<std::size_t> ends;
  std::string text = tape_of(entries, &ends);
  const auto put_word = [&text](std::size_t at, std::uint32_t value) {
    for (std::size_t i = 0; i < 4; ++i) text[at + i] = static_cast<char>((value >> (8 * i)) & 0xff);
  };
  const auto seal = [&](std::size_t at, std::size_t size) {
    put_word(at + size, crc32c(bytes_of(text).subspan(at, size)));
  };
  text[8] = 2;
  seal(0, 16);
  const std::size_t frame = ends[0], payload = frame + 12, before_strip = 12 + 64;
  text.erase(payload + before_strip, 8);
  const std::size_t size = ends[1] - payload - 4 - 8;
  put_word(frame + 4, static_cast<std::uint32_t>(size));
  seal(frame, 8);
  seal(payload, size);
  const Result<Tape> tape = parse_tape(bytes_of(text));
  ASSERT_TRUE(tape) << tape.error().sentence;
  ASSERT_EQ(tape->entries.size(), 1u);
  entries[0].sample.strip_ohm = kNoStrip;
  entries[0].digest.reset();
  expect_same(tape->entries[0], entries[0]);
}

TEST(Tape, AChunkMayNeitherBeMissingNorComeTwice) {
  std::vector<std::size_t> ends;
  // Without its end, which would give the wrong count away.
  std::string text = tape_of(made_up_entries(12), &ends);
  text.resize(ends.back());
  const std::string chunk = text.substr(ends[1], ends[2] - ends[1]);
  EXPECT_FALSE(parse_tape(bytes_of(text.substr(0, ends[1]) + text.substr(ends[2]))));
  EXPECT_FALSE(parse_tape(bytes_of(text.substr(0, ends[2]) + chunk + text.substr(ends[2]))));
}

TEST(Tape, NothingMayFollowTheEnd) {
  EXPECT_FALSE(parse_tape(bytes_of(tape_of(made_up_entries(1)) + 'x')));
}

TEST(Tape, TextThatIsNotUtf8IsRefusedWhenWriting) {
  const TemporaryFolder folder;
  TapeHeader header = made_up_header();
  header.overrides = {"title=R\xf6hre"};
  EXPECT_FALSE(TapeWriter::create(folder / "tape", header));
  EXPECT_FALSE(std::filesystem::exists(folder / "tape"));
}

TEST(Tape, WhatCannotBeReadIsASentence) {
  for (const char* path : {"/nowhere/tape", "/dev/zero", "/tmp"}) {
    const Result<Tape> tape = read_tape(path);
    ASSERT_FALSE(tape) << path;
    EXPECT_NE(tape.error().sentence.find(path), std::string::npos);
  }
}

}  // namespace
}  // namespace fulcrum::record
