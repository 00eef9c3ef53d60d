#include "engine/analysis/picture/flip.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/analysis/picture/colour.h"
#include "haptics/math/functions.h"

namespace fulcrum::analysis::picture {
namespace {

constexpr double kPi = std::numbers::pi;

// The contrast sensitivity of each channel (table 1): a sum of a sqrt(pi / b) exp(-(pi x)^2 / b), x in
// degrees.
struct Bell {
  double a, b;
};
constexpr Bell kLightness{1, 0.0047}, kRedGreen{1, 0.0053};
constexpr Bell kBlueYellow[] = {{34.1, 0.04}, {13.5, 0.025}};
constexpr double kWidestBell = 0.04;

constexpr double kColourExponent = 0.7, kFeatureExponent = 0.5;  // section 4.1 and 4.2: q_c and q_f
constexpr double kSplit = 0.4, kSplitTo = 0.95;  // section 4.1: p_c of the largest difference becomes p_t
constexpr double kFeatureWidth = 0.082;          // section 4.2: degrees, of what an eye takes for an edge

using Plane = std::vector<double>;   // (height x width)
using Kernel = std::vector<double>;  // (2 radius + 1)

struct Size {
  std::size_t width, height;
};

// radius: pixels. weight: of a place that many pixels from the middle.
template <class Weight>
Kernel kernel(int radius, const Weight& weight) {
  Kernel weights;
  for (int x = -radius; x <= radius; ++x) weights.push_back(weight(x));
  return weights;
}

double sum_of(const Kernel& weights) {
  double sum = 0;
  for (const double weight : weights) sum += weight;
  return sum;
}

// Weights above zero then have the sum 1, and those below zero -1.
void balance(Kernel& weights) {
  double above = 0, below = 0;
  for (const double weight : weights) (weight > 0 ? above : below) += weight;
  for (double& weight : weights)
    if (weight != 0) weight /= weight > 0 ? above : -below;
}

// Along rows; a picture goes on beyond its rim as it is there.
Plane filtered_rows(const Plane& plane, const Size& size, const Kernel& weights) {
  const auto radius = static_cast<std::ptrdiff_t>(weights.size() / 2);
  const auto last = static_cast<std::ptrdiff_t>(size.width) - 1;
  Plane result(plane.size());
  std::vector<double> row(size.width + weights.size() - 1);
  for (std::size_t y = 0; y < size.height; ++y) {
    const double* from = &plane[y * size.width];
    for (std::size_t i = 0; i < row.size(); ++i)
      row[i] = from[std::clamp(static_cast<std::ptrdiff_t>(i) - radius, std::ptrdiff_t{0}, last)];
    for (std::size_t x = 0; x < size.width; ++x) {
      double sum = 0;
      for (std::size_t i = 0; i < weights.size(); ++i) sum += weights[i] * row[x + i];
      result[y * size.width + x] = sum;
    }
  }
  return result;
}

Plane turned(const Plane& plane, const Size& size) {
  Plane result(plane.size());
  for (std::size_t y = 0; y < size.height; ++y)
    for (std::size_t x = 0; x < size.width; ++x) result[x * size.height + y] = plane[y * size.width + x];
  return result;
}

Plane filtered(const Plane& plane, const Size& size, const Kernel& along_x, const Kernel& along_y) {
  const Size on_its_side{size.height, size.width};
  const Plane rows = turned(filtered_rows(plane, size, along_x), size);
  return turned(filtered_rows(rows, on_its_side, along_y), on_its_side);
}

// By a round kernel that is a sum of bells, of weight 1 together.
template <std::size_t kBells>
Plane seen(const Plane& plane, const Size& size, const Bell (&bells)[kBells], double pixels_per_degree) {
  const int radius =
      static_cast<int>(std::ceil(3 * std::sqrt(kWidestBell / (2 * kPi * kPi)) * pixels_per_degree));
  Kernel bell[kBells];
  double share[kBells], all = 0;
  for (std::size_t i = 0; i < kBells; ++i) {
    bell[i] = kernel(
        radius, [&](int x) { return math::exp(-math::square(kPi * x / pixels_per_degree) / bells[i].b); });
    const double sum = sum_of(bell[i]);
    for (double& weight : bell[i]) weight /= sum;
    share[i] = bells[i].a * std::sqrt(kPi / bells[i].b) * sum * sum;
    all += share[i];
  }
  Plane result(plane.size(), 0.0);
  for (std::size_t i = 0; i < kBells; ++i) {
    const Plane part = filtered(plane, size, bell[i], bell[i]);
    for (std::size_t at = 0; at < result.size(); ++at) result[at] += share[i] / all * part[at];
  }
  return result;
}

// Section 3, Hunt: the lighter something is, the more colourful it looks.
Vec3 hunt_adjusted(const Vec3& lab) {
  return {lab.x(), 0.01 * lab.x() * lab.y(), 0.01 * lab.x() * lab.z()};
}

// Section 3, HyAB: for colours that are far apart.
double distance(const Vec3& a, const Vec3& b) {
  const Vec3 d = a - b;
  return std::abs(d.x()) + std::sqrt(d.y() * d.y() + d.z() * d.z());
}

struct Seen {
  std::vector<Vec3> colours;  // Hunt-adjusted L*a*b*, as blurred as an eye has them
  Plane edges, points;        // how much of one there is
};

Plane magnitude(const Plane& lightness, const Size& size, const Kernel& across, const Kernel& along) {
  const Plane x = filtered(lightness, size, across, along), y = filtered(lightness, size, along, across);
  Plane result(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) result[i] = std::sqrt(x[i] * x[i] + y[i] * y[i]);
  return result;
}

Seen see(const Image& image, double pixels_per_degree) {
  const Size size{image.width, image.height};
  Plane channels[3];
  Plane lightness;  // 0..1
  for (const std::array<float, 3>& pixel : image.pixels) {
    const Vec3 colour = opponent_of({decoded(pixel[0]), decoded(pixel[1]), decoded(pixel[2])});
    for (int channel = 0; channel < 3; ++channel) channels[channel].push_back(colour[channel]);
    lightness.push_back((colour.x() + 16) / 116);
  }
  const Plane l = seen(channels[0], size, {kLightness}, pixels_per_degree);
  const Plane rg = seen(channels[1], size, {kRedGreen}, pixels_per_degree);
  const Plane by = seen(channels[2], size, kBlueYellow, pixels_per_degree);
  Seen result;
  for (std::size_t i = 0; i < l.size(); ++i) {
    const Vec3 linear = linear_of({l[i], rg[i], by[i]}).cwiseMax(0).cwiseMin(1);
    result.colours.push_back(hunt_adjusted(lab_of(linear)));
  }
  const double deviation = 0.5 * kFeatureWidth * pixels_per_degree;  // pixels
  const int radius = static_cast<int>(std::ceil(3 * deviation));
  const auto bell = [&](int x) { return math::exp(-0.5 * math::square(x / deviation)); };
  Kernel smooth = kernel(radius, bell);
  const double sum = sum_of(smooth);
  for (double& weight : smooth) weight /= sum;
  Kernel first = kernel(
      radius, [&](int x) { return -x * bell(x); });
  Kernel second = kernel(radius, [&](int x) { return (math::square(x / deviation) - 1) * bell(x); });
  balance(first);
  balance(second);
  result.edges = magnitude(lightness, size, first, smooth);
  result.points = magnitude(lightness, size, second, smooth);
  return result;
}

double colour_difference(const Vec3& a, const Vec3& b) {
  static const double largest = math::pow(
      distance(hunt_adjusted(lab_of({0, 1, 0})), hunt_adjusted(lab_of({0, 0, 1}))), kColourExponent);
  const double difference = math::pow(distance(a, b), kColourExponent) / largest;
  return difference < kSplit ? kSplitTo * difference / kSplit
                             : kSplitTo + (1 - kSplitTo) * (difference - kSplit) / (1 - kSplit);
}

}  // namespace

std::vector<double> flip(const Image& reference, const Image& test, double pixels_per_degree) {
  const Seen a = see(reference, pixels_per_degree), b = see(test, pixels_per_degree);
  std::vector<double> result(a.colours.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    const double feature = std::max(std::abs(a.edges[i] - b.edges[i]), std::abs(a.points[i] - b.points[i])) /
                           std::numbers::sqrt2;
    // Section 4.3: where edges differ, too, a difference of colours counts for more.
    result[i] = math::pow(colour_difference(a.colours[i], b.colours[i]),
                          1 - math::pow(std::min(feature, 1.0), kFeatureExponent));
  }
  return result;
}

}  // namespace fulcrum::analysis::picture
