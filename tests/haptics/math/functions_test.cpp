#include "haptics/math/functions.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "haptics/math/split_mix.h"

namespace fulcrum {
namespace {

constexpr int kValues = 200'000;

// A function, its truth to the 64 bits of a long double, and where it is asked.
struct Function {
  std::string name;
  double (*ours)(double, double);
  long double (*truth)(long double, long double);
  double low, high;
  double low_y = 0, high_y = 0;
};

const std::vector<Function> kFunctions{
    {"sin", [](double x, double) { return math::sin(x); },
     [](long double x, long double) { return std::sin(x); }, -100, 100},
    {"cos", [](double x, double) { return math::cos(x); },
     [](long double x, long double) { return std::cos(x); }, -100, 100},
    {"tan", [](double x, double) { return math::tan(x); },
     [](long double x, long double) { return std::tan(x); }, -10, 10},
    {"acos", [](double x, double) { return math::acos(x); },
     [](long double x, long double) { return std::acos(x); }, -1, 1},
    {"atan2", [](double x, double y) { return math::atan2(x, y); },
     [](long double x, long double y) { return std::atan2(x, y); }, -1, 1, -1, 1},
    {"exp", [](double x, double) { return math::exp(x); },
     [](long double x, long double) { return std::exp(x); }, -40, 10},
    {"expm1", [](double x, double) { return math::expm1(x); },
     [](long double x, long double) { return std::expm1(x); }, -40, 10},
    {"log", [](double x, double) { return math::log(x); },
     [](long double x, long double) { return std::log(x); }, 1e-9, 10},
    {"log1p", [](double x, double) { return math::log1p(x); },
     [](long double x, long double) { return std::log1p(x); }, -0.999, 10},
    {"log10", [](double x, double) { return math::log10(x); },
     [](long double x, long double) { return std::log10(x); }, 1e-9, 10},
    {"pow", [](double x, double y) { return math::pow(x, y); },
     [](long double x, long double y) { return std::pow(x, y); }, 0, 20, -5, 5},
    {"sinh", [](double x, double) { return math::sinh(x); },
     [](long double x, long double) { return std::sinh(x); }, -10, 10},
    {"cosh", [](double x, double) { return math::cosh(x); },
     [](long double x, long double) { return std::cosh(x); }, -10, 10},
    {"cbrt", [](double x, double) { return math::cbrt(x); },
     [](long double x, long double) { return std::cbrt(x); }, -1000, 1000},
    {"hypot", [](double x, double y) { return math::hypot(x, y); },
     [](long double x, long double y) { return std::hypot(x, y); }, -1, 1, -1, 1},
};

double ulp(long double truth) {
  const auto nearest = std::abs(static_cast<double>(truth));
  return std::nextafter(nearest, std::numeric_limits<double>::infinity()) - nearest;
}

TEST(Functions, AreOneUnitInTheLastPlaceFromTheTruthAtMost) {
  for (const Function& f : kFunctions) {
    SplitMix random(7);
    double worst = 0, at = 0;
    for (int i = 0; i < kValues; ++i) {
      const double x = std::lerp(f.low, f.high, random.uniform());
      const double y = std::lerp(f.low_y, f.high_y, random.uniform());
      const long double truth = f.truth(x, y);
      const auto error =
          static_cast<double>(std::abs(static_cast<long double>(f.ours(x, y)) - truth) / ulp(truth));
      if (error > worst) worst = error, at = x;
    }
    std::printf("%-6s %.3f ulp\n", f.name.c_str(), worst);
    EXPECT_LE(worst, 1.0) << f.name << " at " << at;
  }
}

// Chosen voxels are rounded to two digits by these.
TEST(Functions, PowersOfTenAreWhole) {
  for (int n = -15; n <= 15; ++n) {
    EXPECT_EQ(math::log10(std::stod("1e" + std::to_string(n))), n);
    EXPECT_EQ(math::pow(10.0, std::abs(n)), std::stod("1e" + std::to_string(std::abs(n))));
  }
}

TEST(Functions, KnowTheEndsOfTheirRange) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(math::exp(-kInfinity), 0);
  EXPECT_EQ(math::exp(0), 1);
  EXPECT_EQ(math::expm1(-kInfinity), -1);
  EXPECT_EQ(math::log(0), -kInfinity);
  EXPECT_EQ(math::log(1), 0);
  EXPECT_EQ(math::log1p(-1), -kInfinity);
  EXPECT_EQ(math::atan2(0, -1), std::numbers::pi);
  EXPECT_EQ(math::atan2(0, 0), 0);
  EXPECT_EQ(math::acos(1), 0);
  EXPECT_EQ(math::pow(0, 0), 1);
  EXPECT_EQ(math::hypot(3, 4), 5);
  EXPECT_EQ(math::cbrt(0), 0);
  EXPECT_TRUE(std::isnan(math::sin(std::numeric_limits<double>::quiet_NaN())));
  EXPECT_TRUE(std::isnan(math::log(-1)));
}

// The same number on every machine. Where it is another, the SLEEF in use is another, and runs differ.
TEST(Functions, HaveTheSameBitsEverywhere) {
  SplitMix random(15);
  std::uint64_t bits = 0;
  for (const Function& f : kFunctions) {
    for (int i = 0; i < 10'000; ++i) {
      const double x = std::lerp(f.low, f.high, random.uniform());
      const double y = std::lerp(f.low_y, f.high_y, random.uniform());
      bits = std::rotl(bits, 5) * 0x9e3779b97f4a7c15u ^ std::bit_cast<std::uint64_t>(f.ours(x, y));
    }
  }
  EXPECT_EQ(bits, 3073600562513874561u);
}

}  // namespace
}  // namespace fulcrum
