#include "tools/content/teeth/arch.h"

// Form: S. Braun, W. Hnat, D. Fender and H. Legan, "The form of the human dental arch", Angle Orthodontist
// 68(1), 1998: z = D (1 - (2x/W)^2)^0.8. A lower
// exponent here makes the front blunter, as the distance between the canines wants it: 24 mm. Width and depth
// are chosen for the line through the contact points.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "haptics/math/functions.h"
#include "tools/content/mesh/profile.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector2d;

constexpr double arch_width = 52.0;  // mm
constexpr double arch_depth = 46.0;  // mm
constexpr double bluntness = 0.6;
constexpr double spacing = 0.1;      // mm, of points along the line
constexpr double arch_reach = 60.0;  // mm, along, to either side

Vector2d form(double x) {
  const double u = std::clamp(x / arch_width, -0.4995, 0.4995);
  return {u * arch_width, arch_depth * math::pow(1.0 - 4.0 * u * u, bluntness) - 0.5 * arch_depth};
}

// Half of the line, from the middle to the jaw's left; where the form ends it goes straight on.
std::vector<Vector2d> half_line() {
  std::vector<Vector2d> points{form(0.0)};
  constexpr int pieces = 20000;
  double rest = spacing;
  for (int i = 0; i < pieces; ++i) {
    // Finer towards the end, where the form runs parallel to z.
    const auto x_at = [](int k) { return 0.4995 * arch_width * math::sin(1.57079632679 * k / pieces); };
    const Vector2d from = form(x_at(i));
    const Vector2d step = form(x_at(i + 1)) - from;
    double done = 0.0;
    while (step.norm() - done >= rest) {
      done += rest;
      points.push_back(from + done / step.norm() * step);
      rest = spacing;
    }
    rest -= step.norm() - done;
  }
  return points;
}

}  // namespace

Arch::Arch() {
  std::vector<Vector2d> half = half_line();
  const auto wanted = static_cast<std::size_t>(arch_reach / spacing) + 1;
  // The form's last stretch runs inwards faster than any jaw does; from here on it is a tangent.
  const auto straight = std::min(half.size(), static_cast<std::size_t>(51.0 / spacing));
  half.resize(straight);
  const Vector2d onward = (half.back() - half[straight - 40]).normalized();
  while (half.size() < wanted) half.push_back(half.back() + spacing * onward);
  for (std::size_t i = half.size(); i-- > 1;) points_.emplace_back(-half[i].x(), half[i].y());
  points_.insert(points_.end(), half.begin(), half.end());
  end_ = arch_reach;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    constexpr std::size_t few = 12;
    const std::size_t before = i > few ? i - few : 0;
    const std::size_t after = std::min(i + few, points_.size() - 1);
    tangents_.push_back((points_[after] - points_[before]).normalized());
  }
}

Arch::Place Arch::at(double along) const {
  const double index = (along + end_) / spacing;
  const auto i = static_cast<std::size_t>(std::clamp(index, 0.0, static_cast<double>(points_.size() - 2)));
  const Vector2d step = points_[i + 1] - points_[i];
  // Over a few mm, so that neighbouring pieces do not turn by jumps.
  const std::size_t before = i > 20 ? i - 20 : 0;
  const std::size_t after = std::min(i + 21, points_.size() - 1);
  const Vector2d onward = (points_[after] - points_[before]).normalized();
  return {points_[i] + (index - static_cast<double>(i)) * step, onward, {-onward.y(), onward.x()}};
}

Arch::Foot Arch::foot(const Vector2d& p) const {
  double nearest2 = std::numeric_limits<double>::infinity();
  std::size_t at = 0;
  constexpr std::size_t stride = 30;
  const auto look = [&](std::size_t i) {
    const double far2 = (points_[i] - p).squaredNorm();
    if (far2 < nearest2) {
      nearest2 = far2;
      at = i;
    }
  };
  for (std::size_t i = 0; i < points_.size(); i += stride) look(i);
  const std::size_t low = at > stride ? at - stride : 0;
  const std::size_t high = std::min(at + stride, points_.size() - 1);
  for (std::size_t i = low; i <= high; ++i) look(i);
  // Between two points the tangent turns evenly: no jumps where the straight pieces meet, which from the
  // inside of the arch would be seen as scratches.
  const auto ahead = [&](std::size_t i) { return (p - points_[i]).dot(tangents_[i]); };
  const std::size_t last = points_.size() - 2;
  const std::size_t from = std::min(at > 0 && ahead(at) < 0.0 ? at - 1 : at, last);
  const double before = ahead(from);
  const double t = std::clamp(before / (before - ahead(from + 1)), 0.0, 1.0);
  const Vector2d foot = points_[from] + t * (points_[from + 1] - points_[from]);
  const Vector2d off = p - foot;
  const double side = tangents_[from].x() * off.y() - tangents_[from].y() * off.x();
  return {.along = (static_cast<double>(from) + t) * spacing - end_,
          .outward = std::copysign(off.norm(), side)};
}

double occlusal_height(double along) {
  static const Profile curve(
      {{0, 0.0}, {6, 0.0}, {14, 0.35}, {22, -0.5}, {30, -1.1}, {39, -1.35}, {48, -0.7}, {56, 0.2}});
  return curve(std::abs(along));
}

}  // namespace fulcrum::content
