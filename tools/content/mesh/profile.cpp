#include "tools/content/mesh/profile.h"

#include <cstddef>
#include <utility>

namespace fulcrum::content {

Profile::Profile(std::vector<Knot> knots) : knots_(std::move(knots)), slopes_(knots_.size(), 0.0) {
  const auto secant = [&](std::size_t i) {
    return (knots_[i + 1].value - knots_[i].value) / (knots_[i + 1].at - knots_[i].at);
  };
  for (std::size_t i = 1; i + 1 < knots_.size(); ++i) {
    const double before = secant(i - 1);
    const double after = secant(i);
    // The harmonic mean keeps both pieces monotone; at a crest the curve is level.
    slopes_[i] = before * after > 0.0 ? 2.0 * before * after / (before + after) : 0.0;
  }
  if (knots_.size() > 1) {
    slopes_.front() = secant(0);
    slopes_.back() = secant(knots_.size() - 2);
  }
}

double Profile::operator()(double at) const {
  if (at <= knots_.front().at) return knots_.front().value;
  if (at >= knots_.back().at) return knots_.back().value;
  std::size_t i = 0;
  while (at > knots_[i + 1].at) ++i;
  const double width = knots_[i + 1].at - knots_[i].at;
  const double t = (at - knots_[i].at) / width;
  const double s = 1.0 - t;
  return s * s * ((1.0 + 2.0 * t) * knots_[i].value + t * width * slopes_[i]) +
         t * t * ((1.0 + 2.0 * s) * knots_[i + 1].value - s * width * slopes_[i + 1]);
}

}  // namespace fulcrum::content
