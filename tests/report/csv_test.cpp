#include "engine/report/csv.h"

#include <gtest/gtest.h>

#include <cmath>
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

}  // namespace
}  // namespace fulcrum::report
