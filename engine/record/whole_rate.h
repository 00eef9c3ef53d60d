#pragma once
// Ticks per second, where that is a whole number.

#include <cmath>
#include <optional>

namespace fulcrum::record {

// 3 * 0.001 is 0.003 and a bit; 3 / 1000 is the number that prints as 0.003.
inline std::optional<double> whole_rate(double tick_s) {
  const double rate = std::round(1 / tick_s);
  return std::abs(rate * tick_s - 1) < 1e-9 ? std::optional(rate) : std::nullopt;
}

}  // namespace fulcrum::record
