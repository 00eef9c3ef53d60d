// Reference: every finite double reads back to the same bits; the text has neither locale nor the sign of a
// zero.
#include "engine/files/number_text.h"

#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <clocale>
#include <cmath>
#include <limits>
#include <locale>
#include <random>

namespace fulcrum {
namespace {

std::string text(auto value) {
  std::string to;
  append_number(to, value);
  return to;
}

TEST(NumberText, IsShort) {
  EXPECT_EQ(text(0.003), "0.003");
  EXPECT_EQ(text(0.1 + 0.2), "0.30000000000000004");
  EXPECT_EQ(text(-2.5), "-2.5");
  EXPECT_EQ(text(std::int64_t{-7}), "-7");
  EXPECT_EQ(text(std::numeric_limits<std::int64_t>::min()), "-9223372036854775808");
}

TEST(NumberText, LeavesOutSignsThatSayNothing) {
  EXPECT_EQ(text(-0.0), "0");
  EXPECT_EQ(text(std::numeric_limits<double>::quiet_NaN()), "nan");
  EXPECT_EQ(text(-std::numeric_limits<double>::quiet_NaN()), "nan");
  EXPECT_EQ(text(-std::numeric_limits<double>::infinity()), "-inf");
}

TEST(NumberText, ReadsBackToTheSameBits) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 100000; ++i) {
    const double value = std::bit_cast<double>(random());
    if (!std::isfinite(value)) continue;
    const std::string written = text(value);
    double read = 0;
    std::from_chars(written.data(), written.data() + written.size(), read);
    ASSERT_EQ(std::bit_cast<std::uint64_t>(read), std::bit_cast<std::uint64_t>(value)) << written;
  }
}

class DecimalComma : public std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(NumberText, KnowsNoLocale) {
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new DecimalComma));
  EXPECT_EQ(text(1234.5), "1234.5");
  EXPECT_EQ(text(std::int64_t{1234567}), "1234567");
  std::locale::global(before);
}

TEST(NumberText, KnowsNoGerman) {
  if (std::setlocale(LC_ALL, "de_DE.UTF-8") == nullptr)
    GTEST_SKIP() << "this machine has no locale de_DE.UTF-8";
  EXPECT_EQ(text(1234.5), "1234.5");
  std::setlocale(LC_ALL, "C");
}

}  // namespace
}  // namespace fulcrum
