#include "engine/render/scatter_taps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/render/look.h"

namespace fulcrum::render {
namespace {

// The distance within which this part of the light comes out, for a d of 1. Golubev 2018: the cubic equation
// that the cumulative distribution 1 - (e^-x + 3 e^(-x/3)) / 4 is in e^(-x/3), solved.
double distance_within(double part) {
  const double beyond = 1.0 - part;
  const double g = 1.0 + 4.0 * beyond * (2.0 * beyond + std::sqrt(1.0 + 4.0 * beyond * beyond));
  const double root = std::cbrt(g);
  return 3.0 * std::log((1.0 + 1.0 / root + root) / (4.0 * beyond));
}

// Neighbours are far apart in the profile: a matrix of B. Bayer, 1973, row by row.
constexpr std::array<int, kScatterPatterns> kOrder = {0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};

bool spreads_below(const VisualDesc& desc, const Instance& instance) {
  return is_scattering(look_of(desc.materials[instance.material]).value_or(0));
}

}  // namespace

std::vector<glm::vec4> scatter_taps(int per_pixel) {
  const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));  // a spiral of H. Vogel, 1979
  const int all = per_pixel * static_cast<int>(kScatterPatterns);
  std::vector<glm::vec4> taps;
  for (const int first : kOrder)
    for (int i = 0; i < per_pixel; ++i) {
      const int nth = i * static_cast<int>(kScatterPatterns) + first;
      const double r = distance_within((nth + 0.5) / all);
      const double angle = golden * nth;
      taps.emplace_back(r * std::cos(angle), r * std::sin(angle), r, r / (std::exp(-r) + std::exp(-r / 3.0)));
    }
  return taps;
}

std::vector<std::uint32_t> scatter_numbers(const VisualDesc& desc) {
  std::vector<std::uint32_t> numbers;
  std::uint32_t last = 0;
  for (const Instance& instance : desc.instances)
    numbers.push_back(spreads_below(desc, instance) ? ++last : 0);
  return numbers;
}

std::vector<glm::vec4> scatter_distances(const VisualDesc& desc) {
  std::vector<glm::vec4> distances;
  for (const Instance& instance : desc.instances)
    if (spreads_below(desc, instance))
      distances.push_back(with_greatest(desc.materials[instance.material].detail->scatter_distance));
  return distances;
}

glm::vec4 with_greatest(const glm::vec3& distance) {
  return {distance, std::max({distance.r, distance.g, distance.b})};
}

}  // namespace fulcrum::render
