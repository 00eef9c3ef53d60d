#include "engine/scenario/words.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace fulcrum::scenario {
namespace {

TEST(Words, CountsEdits) {
  EXPECT_EQ(edit_distance("", ""), 0u);
  EXPECT_EQ(edit_distance("stifness", "stiffness"), 1u);
  EXPECT_EQ(edit_distance("stfifness", "stiffness"), 1u);  // a swap of neighbours is one slip
  EXPECT_EQ(edit_distance("abc", ""), 3u);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
  EXPECT_EQ(edit_distance("sitting", "kitten"), 3u);
}

TEST(Words, NamesTheNearestThatIsNear) {
  const std::array<std::string_view, 3> keys{"stiffness", "damping", "seed"};
  EXPECT_EQ(nearest("stifness", keys), "stiffness");
  EXPECT_EQ(nearest("damp", keys), std::nullopt);
  EXPECT_EQ(nearest("sed", keys), "seed");
  EXPECT_EQ(nearest("", keys), std::nullopt);
  EXPECT_EQ(nearest(std::string(100'000, 's'), keys), std::nullopt);
}

TEST(Words, ReadsNumbersAsYamlWritesThem) {
  EXPECT_EQ(parse_number("12"), 12.0);
  EXPECT_EQ(parse_number("-0.5"), -0.5);
  EXPECT_EQ(parse_number("+3"), 3.0);
  EXPECT_EQ(parse_number(".5"), 0.5);
  EXPECT_EQ(parse_number("5."), 5.0);
  EXPECT_EQ(parse_number("1e-3"), 1e-3);
  EXPECT_EQ(parse_number("1e999"), INFINITY);
  EXPECT_EQ(parse_number("-1e999"), -INFINITY);
  EXPECT_EQ(parse_number("1e-999"), 0.0);
  EXPECT_EQ(parse_number(".inf"), INFINITY);
  EXPECT_TRUE(std::isnan(*parse_number(".nan")));
  for (const char* text :
       {"", ".", "-", "e5", "1e", "1 2", "0x10", "nan", "inf", "1_000", "1,5", "5 mm", "--1"})
    EXPECT_EQ(parse_number(text), std::nullopt) << text;
}

TEST(Words, WritesNumbersThatReadBack) {
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(20000), "20000");
  EXPECT_EQ(widened(0.96F), 0.96);
  EXPECT_EQ(static_cast<float>(widened(0.1F)), 0.1F);
}

TEST(Words, QuotesOnOneShortLine) {
  EXPECT_EQ(in_quotes("a\nb\x1b[2J"), "'a b [2J'");
  const std::string umlauts =
      "a\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3"
      "\xa4"
      "\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4"
      "\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4";
  const std::string quoted = in_quotes(umlauts);
  EXPECT_TRUE(quoted.ends_with("\xa4...'")) << quoted;  // a character is not cut in two
}

}  // namespace
}  // namespace fulcrum::scenario
