#include "engine/analysis/compare/student_t.h"

#include <cmath>
#include <numbers>

#include "haptics/math/functions.h"

namespace fulcrum::analysis::compare {
namespace {

// P(|T| < t) with tan(theta) = t / sqrt(degrees): finite sums for whole degrees of freedom (Abramowitz and
// Stegun, "Handbook of mathematical functions", 26.7.3 and 26.7.4).
double central_probability(double theta, int degrees) {
  const double c = math::cos(theta), s = math::sin(theta);
  double sum = 0;
  if (degrees % 2 == 0) {
    double term = 1;
    for (int k = 1; k < degrees; k += 2) {
      sum += term;
      term *= c * c * k / (k + 1);
    }
    return s * sum;
  }
  double term = c;
  for (int k = 2; k < degrees; k += 2) {
    sum += term;
    term *= c * c * k / (k + 1);
  }
  return 2 / std::numbers::pi * (theta + s * sum);
}

}  // namespace

double t_quantile(double p, int degrees) {
  const double wanted = std::abs(2 * p - 1);
  double low = 0, high = std::numbers::pi / 2;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (low + high);
    (central_probability(middle, degrees) < wanted ? low : high) = middle;
  }
  return std::copysign(std::sqrt(degrees) * math::tan(0.5 * (low + high)), p - 0.5);
}

}  // namespace fulcrum::analysis::compare
