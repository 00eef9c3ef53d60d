#pragma once
// Elementary functions whose last bit is the same on every x86-64 processor. A C library's own are not: glibc
// takes other code, rounded otherwise, where the processor has AVX2 or fused multiply-add. What reaches a
// tick or a bake calls these, and a test of the object files (tests/tools/libm_test.sh) keeps <cmath>'s out.
//
// They are SLEEF's: N. Shibata, F. Petrogalli, "SLEEF: A Portable Vectorized Library of C Standard
// Mathematical Functions", IEEE TPDS 31 (2020); at most 1 unit in the last place from the truth. std::sqrt,
// floor, ceil, round, fmod and remainder are exact everywhere, and stay.

namespace fulcrum::math {

double sin(double x) noexcept;
double cos(double x) noexcept;
double tan(double x) noexcept;
double acos(double x) noexcept;
double atan2(double y, double x) noexcept;

double exp(double x) noexcept;
double expm1(double x) noexcept;
double log(double x) noexcept;
double log1p(double x) noexcept;
double log10(double x) noexcept;
double pow(double x, double y) noexcept;
double sinh(double x) noexcept;
double cosh(double x) noexcept;

double cbrt(double x) noexcept;
double hypot(double x, double y) noexcept;

constexpr double square(double x) noexcept {
  return x * x;
}

}  // namespace fulcrum::math
