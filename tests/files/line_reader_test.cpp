#include "engine/files/line_reader.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/files/temporary_folder.h"

namespace fulcrum {
namespace {

using test::TemporaryFolder;

LineReader reader_of(const TemporaryFolder& folder, const std::string& text) {
  folder.write("text", text);
  return LineReader(std::move(*RegularFile::open(folder / "text")));
}

TEST(LineReader, GivesEachLine) {
  const TemporaryFolder folder;
  LineReader lines = reader_of(folder, "one\n\nthree\r\nfour");
  std::vector<std::string> all;
  while (const auto line = lines.next()) {
    all.emplace_back(*line);
    EXPECT_EQ(lines.line(), all.size());
  }
  EXPECT_EQ(all, (std::vector<std::string>{"one", "", "three\r", "four"}));
  EXPECT_FALSE(lines.ended());
  EXPECT_FALSE(lines.fault());
  LineReader empty = reader_of(folder, "");
  EXPECT_FALSE(empty.next());
  EXPECT_TRUE(empty.ended());
}

// Lengths around the size of what is read at a time.
TEST(LineReader, GivesLinesThatWereReadInPieces) {
  const TemporaryFolder folder;
  const std::size_t longest = LineReader::kLongest;
  std::string text;
  const std::vector<std::size_t> sizes{longest, 0, 1, longest - 1, longest, longest / 2, longest - 7, 3};
  for (std::size_t i = 0; i < sizes.size(); ++i)
    text += std::string(sizes[i], static_cast<char>('a' + i)) + '\n';
  LineReader lines = reader_of(folder, text);
  for (std::size_t i = 0; i < sizes.size(); ++i)
    ASSERT_EQ(lines.next(), std::string(sizes[i], static_cast<char>('a' + i))) << i;
  EXPECT_FALSE(lines.next());
  EXPECT_TRUE(lines.ended());
}

TEST(LineReader, RefusesALineWithoutEnd) {
  const TemporaryFolder folder;
  for (const bool ended : {false, true}) {
    LineReader lines =
        reader_of(folder, "good\n" + std::string(LineReader::kLongest + 1, ',') + (ended ? "\nmore\n" : ""));
    EXPECT_EQ(lines.next(), "good");
    EXPECT_FALSE(lines.next());
    ASSERT_TRUE(lines.fault());
    EXPECT_EQ(lines.fault()->sentence, "line 2 is longer than 65536 bytes");
    EXPECT_FALSE(lines.next());
  }
}

}  // namespace
}  // namespace fulcrum
