#include "haptics/geometry/bounds.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

namespace fulcrum {
namespace {

// Vectors of the compiler, gcc's and clang's: a few operations on four lanes, which every machine has.
using Four __attribute__((vector_size(16))) = float;
using Mask __attribute__((vector_size(16))) = std::int32_t;

Four load(const std::array<float, 4>& lanes) {
  Four four;
  std::memcpy(&four, lanes.data(), sizeof four);
  return four;
}

void store(const Four& four, std::array<float, 4>& lanes) {
  std::memcpy(lanes.data(), &four, sizeof four);
}

// Lanes of a where the mask has them, else of b.
Four chosen(const Mask& mask, const Four& a, const Four& b) {
  return std::bit_cast<Four>((mask & std::bit_cast<Mask>(a)) | (~mask & std::bit_cast<Mask>(b)));
}

Four all(double x) {
  const auto narrow = static_cast<float>(x);
  return Four{narrow, narrow, narrow, narrow};
}

unsigned bits_of(const Mask& mask) {
  return static_cast<unsigned>((mask[0] & 1) | (mask[1] & 2) | (mask[2] & 4) | (mask[3] & 8));
}

constexpr float kInfinity = std::numeric_limits<float>::infinity();
// Above what the cosine of an angle between two directions errs by in single precision.
constexpr float kRoundOfCosine = 2e-6F;
// Likewise of a place that is turned and moved, over its distance from the origin.
constexpr float kRoundOfPlace = 1e-6F;

float below(double x) {
  return std::nextafter(static_cast<float>(x), -kInfinity);
}
float above(double x) {
  return std::nextafter(static_cast<float>(x), kInfinity);
}

void set_box(Bounds& bounds, const Vec3& low, const Vec3& high) {
  for (int i = 0; i < 3; ++i) {
    bounds.low[static_cast<std::size_t>(i)] = below(low[i]);
    bounds.high[static_cast<std::size_t>(i)] = above(high[i]);
  }
}

void set_axis(Bounds& bounds, const Vec3& axis) {
  for (int i = 0; i < 3; ++i) bounds.axis[static_cast<std::size_t>(i)] = static_cast<float>(axis[i]);
}

}  // namespace

Bounds Bounds::of(const Box3& box, const NormalCone& cone) {
  Bounds bounds;
  set_box(bounds, box.min(), box.max());
  set_axis(bounds, cone.axis());
  bounds.cosine = static_cast<float>(cone.cosine());
  bounds.sine = static_cast<float>(cone.sine());
  return bounds;
}

Bounds4::Bounds4() : axis_{}, cosine_{}, sine_{} {
  for (Lanes& each : low_) each.fill(kInfinity);
  for (Lanes& each : high_) each.fill(-kInfinity);
}

void Bounds4::set(unsigned lane, const Bounds& bounds) {
  for (std::size_t i = 0; i < 3; ++i) {
    low_[i][lane] = bounds.low[i];
    high_[i][lane] = bounds.high[i];
    axis_[i][lane] = bounds.axis[i];
  }
  cosine_[lane] = bounds.cosine;
  sine_[lane] = bounds.sine;
}

Bounds Bounds4::operator[](unsigned lane) const {
  Bounds bounds;
  for (std::size_t i = 0; i < 3; ++i) {
    bounds.low[i] = low_[i][lane];
    bounds.high[i] = high_[i][lane];
    bounds.axis[i] = axis_[i][lane];
  }
  bounds.cosine = cosine_[lane];
  bounds.sine = sine_[lane];
  return bounds;
}

Bounds4 Bounds4::moved(const Mat3& R, const Vec3& p, double reach, const NormalCone& slack) const noexcept {
  std::array<Four, 3> centre, half, axis;
  Four farthest = all(p.lpNorm<1>() + reach);  // m, from W's origin, at least
  for (std::size_t i = 0; i < 3; ++i) {
    const Four from = load(low_[i]), to = load(high_[i]);
    centre[i] = 0.5F * (from + to);
    half[i] = 0.5F * (to - from);
    axis[i] = load(axis_[i]);
    farthest += half[i] + chosen(centre[i] < 0.0F, -centre[i], centre[i]);
  }
  const Four margin = all(reach) + kRoundOfPlace * farthest;
  Bounds4 result;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const Four x = all(R(row, 0)), y = all(R(row, 1)), z = all(R(row, 2));
    const Four middle = x * centre[0] + y * centre[1] + z * centre[2] + all(p[row]);
    const Four out = all(std::abs(R(row, 0))) * half[0] + all(std::abs(R(row, 1))) * half[1] +
                     all(std::abs(R(row, 2))) * half[2] + margin;
    store(middle - out, result.low_[i]);
    store(middle + out, result.high_[i]);
    store(x * axis[0] + y * axis[1] + z * axis[2], result.axis_[i]);
  }
  const Four cosine = load(cosine_), sine = load(sine_), c = all(slack.cosine()), s = all(slack.sine());
  const Four wider = sine * c + cosine * s;
  const Mask everywhere = wider < 0.0F;  // more than half a turn
  store(chosen(everywhere, all(-1), cosine * c - sine * s), result.cosine_);
  store(chosen(everywhere, all(0), wider), result.sine_);
  return result;
}

unsigned Bounds4::overlapping(const Bounds& one) const noexcept {
  Mask near = ~Mask{};
  for (std::size_t i = 0; i < 3; ++i) near &= (load(low_[i]) <= one.high[i]) & (load(high_[i]) >= one.low[i]);
  return bits_of(near);
}

unsigned Bounds4::meeting(const Bounds& one) const noexcept {
  const unsigned overlap = overlapping(one);
  if (overlap == 0) return 0;
  // Opposite as far as the angles of both cones together: cos(a + b) <= -axis . axis', or a + b is half a
  // turn or more.
  const Four cosine_b = load(cosine_), sine_b = load(sine_);
  const Four cosine = one.cosine * cosine_b - one.sine * sine_b,
             sine = one.sine * cosine_b + one.cosine * sine_b;
  const Four dot = load(axis_[0]) * one.axis[0] + load(axis_[1]) * one.axis[1] + load(axis_[2]) * one.axis[2];
  const Mask half_a_turn = (sine < 0.0F) | ((sine <= kRoundOfCosine) & (cosine < 0.0F));
  return overlap & bits_of((cosine + dot <= kRoundOfCosine) | half_a_turn);
}

}  // namespace fulcrum
