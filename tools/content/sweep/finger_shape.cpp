#include "tools/content/sweep/finger_shape.h"

#include <algorithm>
#include <cmath>

#include "haptics/math/functions.h"
#include "tools/content/mesh/smooth.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double before = 12.0;    // mm, of the axis before s = 0
constexpr double step = 0.25;      // mm, between its points
constexpr double cap = 6.6;        // mm, from s = 0 to the tip
constexpr double roundness = 2.3;  // exponent of the ovals; 2 is an ellipse
constexpr double nail_middle = 2.4, nail_half_length = 6.5, nail_half_width = 5.7;  // mm

double gauge(double u, double v, double w, double exponent) {
  return math::pow(
      math::pow(std::abs(u), exponent) + math::pow(std::abs(v), exponent) + math::pow(std::abs(w), exponent),
      1.0 / exponent);
}

}  // namespace

FingerShape::FingerShape()
    : half_width_({{-2, 7.4}, {0, 7.4}, {6, 8.1}, {12, 8.3}, {19, 8.5}, {25, 8.1}, {33, 8.5}, {45, 10.0}}),
      over_(
          {{-2, 5.0}, {0, 5.0}, {6, 5.5}, {12, 5.7}, {18, 6.3}, {21, 6.4}, {28, 6.4}, {36, 7.0}, {45, 8.4}}),
      under_(
          {{-2, 6.7}, {0, 6.7}, {4, 7.3}, {8, 7.4}, {14, 6.8}, {19, 6.4}, {26, 7.4}, {34, 7.7}, {45, 8.4}}) {
  Vector2d p(-before * math::sin(inclination(-before)), -before * math::cos(inclination(-before)));
  for (double s = -before; s < end + before; s += step) {
    axis_.push_back(p);
    const double angle = inclination(s + 0.5 * step);
    p += step * Vector2d(math::sin(angle), math::cos(angle));
  }
  // Of the tip's cap and the first of the pad.
  double least = 0.0;
  for (double s = -cap; s < 8.0; s += 0.01) {
    double h = -under_(s);
    if (s < 0.0) h *= math::pow(std::max(0.0, 1.0 - math::pow(-s / cap, roundness)), 1.0 / roundness);
    const double y = point({s, 0.0, h}).y();
    if (y < least) {
      least = y;
      lowest_ = s;
    }
  }
}

double FingerShape::inclination(double s) const {
  return degree * (27.0 + 13.0 * smooth_step(15.0, 26.0, s));
}

Vector3d FingerShape::along(double s) const {
  return {0.0, math::sin(inclination(s)), math::cos(inclination(s))};
}

Vector3d FingerShape::above(double s) const {
  return {0.0, math::cos(inclination(s)), -math::sin(inclination(s))};
}

Vector3d FingerShape::point(const Place& place) const {
  const double at = std::clamp((place.s + before) / step, 0.0, static_cast<double>(axis_.size() - 2));
  const auto i = static_cast<std::size_t>(at);
  const Vector2d p = axis_[i] + (at - static_cast<double>(i)) * (axis_[i + 1] - axis_[i]);
  return Vector3d(place.x, p.x(), p.y()) + place.h * above(place.s);
}

FingerShape::Place FingerShape::place(const Vector3d& p) const {
  double s = along(0.0).dot(p);
  for (int i = 0; i < 5; ++i)
    s = std::clamp(s + along(s).dot(p - point({s, p.x(), 0.0})), -before + step, end + before - 2.0 * step);
  return {s, p.x(), above(s).dot(p - point({s, p.x(), 0.0}))};
}

double FingerShape::oval(double s, double x, double h) const {
  return gauge(x / half_width_(s), h / (h > 0.0 ? over_(s) : under_(s)), std::min(s, 0.0) / cap, roundness);
}

Vector3d FingerShape::surface(double s, double angle, double off) const {
  const auto part = [](double v) { return std::copysign(math::pow(std::abs(v), 2.0 / roundness), v); };
  const double c = math::cos(angle), v = math::sin(angle);
  return point({s, part(c) * half_width_(s) + off * c, part(v) * (v > 0.0 ? over_(s) : under_(s)) + off * v});
}

double FingerShape::bare(const Vector3d& p) const {
  const Place at = place(p);
  return 6.4 * (oval(at.s, at.x, at.h) - 1.0);
}

double FingerShape::from_nail(const Vector3d& p) const {
  const Place at = place(p);
  return nail_half_width *
         (gauge(at.x / nail_half_width, (at.s - nail_middle) / nail_half_length, 0.0, 3.0) - 1.0);
}

double FingerShape::skin(const Vector3d& p) const {
  const Place at = place(p);
  double d = 6.4 * (oval(at.s, at.x, at.h) - 1.0);
  const double top = smooth_step(-1.0, 3.5, at.h), below = smooth_step(0.0, -3.5, at.h);
  // Wrinkles over the last joint, and one fold under it.
  for (const double line : {16.4, 18.0, 19.3, 20.7, 22.4}) {
    const double bent = at.s - line - 0.35 * math::sin(0.9 * at.x + line);
    d += (0.30 - 0.04 * std::abs(line - 19.3)) * top * bump(bent, 0.38);
  }
  d -= 0.35 * top * bump(at.s - 19.4, 4.0);
  d += 0.55 * below * bump(at.s - 19.4 - 0.02 * at.x * at.x, 0.7);
  // Under the nail it gives way; beside and behind the nail it rises.
  const double out = from_nail(p);
  d += 0.5 * top * smooth_step(0.25, -0.35, out);
  d -= 0.5 * top * bump(out - 0.75, 0.6) * smooth_step(-3.4, 0.4, at.s);
  return std::max(d, at.s - end);
}

double FingerShape::nail(const Vector3d& p) const {
  const Place at = place(p);
  const double sheet = std::abs(6.4 * (oval(at.s, at.x, at.h) - 1.0) + 0.15) - 0.55;
  return smooth_max(smooth_max(sheet, from_nail(p), 0.35), 1.0 - at.h, 0.3);
}

}  // namespace fulcrum::content
