#include "haptics/geometry/bounds-inl.h"

#include <cmath>
#include <limits>

namespace fulcrum {

using namespace lanes;

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
// What a place that is turned and moved errs by in single precision, over its distance from the origin.
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

Bounds4 Bounds4::swept(const Sweep& sweep) const noexcept {
  std::array<Four, 3> centre, half, axis;
  Four squared = all(0);  // m^2, of what is farthest from the frame's origin
  for (std::size_t i = 0; i < 3; ++i) {
    const Four from = load(low_[i]), to = load(high_[i]);
    centre[i] = 0.5F * (from + to);
    half[i] = 0.5F * (to - from);
    axis[i] = load(axis_[i]);
    const Four out = half[i] + chosen(centre[i] < 0.0F, -centre[i], centre[i]);
    squared += out * out;
  }
  Four radius = squared;
  for (int lane = 0; lane < 4; ++lane) radius[lane] = std::sqrt(squared[lane]);
  const Four margin = all(sweep.reach) + all(sweep.turn) * radius +
                      kRoundOfPlace * (all(sweep.p_from.norm() + sweep.p_to.norm() + sweep.reach) + radius);
  Bounds4 result;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const auto turned = [row](const Mat3& R, const std::array<Four, 3>& v) {
      return all(R(row, 0)) * v[0] + all(R(row, 1)) * v[1] + all(R(row, 2)) * v[2];
    };
    const Four from = turned(sweep.R_from, centre) + all(sweep.p_from[row]),
               to = turned(sweep.R_to, centre) + all(sweep.p_to[row]);
    const Four out_from = turned(sweep.R_from.cwiseAbs(), half), out_to = turned(sweep.R_to.cwiseAbs(), half);
    const Four low_from = from - out_from, low_to = to - out_to;
    const Four high_from = from + out_from, high_to = to + out_to;
    store(chosen(low_from < low_to, low_from, low_to) - margin, result.low_[i]);
    store(chosen(high_from > high_to, high_from, high_to) + margin, result.high_[i]);
    store(turned(sweep.R_middle, axis), result.axis_[i]);
  }
  const Four cosine = load(cosine_), sine = load(sine_), c = all(sweep.slack.cosine()),
             s = all(sweep.slack.sine());
  const Four wider = sine * c + cosine * s;
  const Mask everywhere = wider < 0.0F;  // more than half a turn
  store(chosen(everywhere, all(-1), cosine * c - sine * s), result.cosine_);
  store(chosen(everywhere, all(0), wider), result.sine_);
  return result;
}

}  // namespace fulcrum
