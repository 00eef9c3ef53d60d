#pragma once
// Seeded random numbers, the same everywhere: splitmix64 (G. Steele, D. Lea, C. Flood, "Fast splittable
// pseudorandom number generators", OOPSLA 2014).

#include <cmath>
#include <cstdint>
#include <numbers>

#include "haptics/math/functions.h"

namespace fulcrum {

class SplitMix {
public:
  explicit SplitMix(std::uint64_t seed) : state_(seed) {}

  double uniform() noexcept {  // 0 to 1, without 1
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
  }

  double normal() noexcept {  // mean 0, standard deviation 1 (Box and Muller 1958)
    const double radius = std::sqrt(-2 * math::log(1 - uniform()));
    return radius * math::cos(2 * std::numbers::pi * uniform());
  }

private:
  std::uint64_t state_;
};

}  // namespace fulcrum
