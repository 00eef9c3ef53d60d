#include "engine/report/csv.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>

namespace fulcrum::report {
namespace {

TEST(Csv, NumbersReadBackToTheSameBits) {
  Csv csv({"a", "b", "c"});
  csv.row({0.1, 1.0 / 3, -0.0});
  csv.row({1e300, std::nan(""), std::numeric_limits<double>::denorm_min()});
  EXPECT_EQ(csv.text(), "a,b,c\n0.1,0.3333333333333333,0\n1e+300,nan,5e-324\n");
}

TEST(Csv, TextWithCommasOrQuotesIsQuoted) {
  Csv csv({"name", "what, exactly"});
  csv.row({"a \"b\"", "line\nline"});
  csv.row({"plain", 1.0});
  EXPECT_EQ(csv.text(), "name,\"what, exactly\"\n\"a \"\"b\"\"\",\"line\nline\"\nplain,1\n");
}

TEST(WriteFile, WritesANewOneAndLeavesAnOldOne) {
  std::string folder = "/tmp/fulcrum_csv_XXXXXX";
  ASSERT_NE(::mkdtemp(folder.data()), nullptr);
  const std::filesystem::path path = std::filesystem::path(folder) / "t.csv";
  EXPECT_FALSE(write_file(path, "a\n1\n"));
  const std::optional<Error> again = write_file(path, "b\n");
  ASSERT_TRUE(again);
  EXPECT_NE(again->sentence.find("t.csv"), std::string::npos);
  std::ifstream file(path);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), "a\n1\n");
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace fulcrum::report
