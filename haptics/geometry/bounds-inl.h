#pragma once
// What a descent does with bounds at every step, to be inlined there.

#include <bit>
#include <cstring>

#include "haptics/geometry/bounds.h"

namespace fulcrum {
namespace lanes {

// Vectors of the compiler, gcc's and clang's: a few operations on four lanes, which every machine has.
using Four __attribute__((vector_size(16))) = float;
using Mask __attribute__((vector_size(16))) = std::int32_t;

inline Four load(const std::array<float, 4>& lanes) {
  Four four;
  std::memcpy(&four, lanes.data(), sizeof four);
  return four;
}

inline void store(const Four& four, std::array<float, 4>& lanes) {
  std::memcpy(lanes.data(), &four, sizeof four);
}

// Lanes of a where the mask has them, else of b.
inline Four chosen(const Mask& mask, const Four& a, const Four& b) {
  return std::bit_cast<Four>((mask & std::bit_cast<Mask>(a)) | (~mask & std::bit_cast<Mask>(b)));
}

inline Four all(double x) {
  const auto narrow = static_cast<float>(x);
  return Four{narrow, narrow, narrow, narrow};
}

// One lane of it, four times.
template <unsigned kLane>
Four all_of(const Four& four) {
  return __builtin_shufflevector(four, four, kLane, kLane, kLane, kLane);
}

inline unsigned bits_of(const Mask& mask) {
#ifdef __SSE__
  return static_cast<unsigned>(__builtin_ia32_movmskps(std::bit_cast<Four>(mask)));
#else
  return static_cast<unsigned>((mask[0] & 1) | (mask[1] & 2) | (mask[2] & 4) | (mask[3] & 8));
#endif
}

// Above what the cosine of an angle between two directions errs by in single precision.
inline constexpr float kRoundOfCosine = 2e-6F;

}  // namespace lanes

// Of a mask of lanes.
inline unsigned lowest_bit(unsigned bits) {
  return static_cast<unsigned>(std::countr_zero(bits));
}

inline Bounds Bounds4::operator[](unsigned lane) const {
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

inline float Bounds4::size(unsigned lane) const {
  return high_[0][lane] - low_[0][lane] + (high_[1][lane] - low_[1][lane]) + (high_[2][lane] - low_[2][lane]);
}

inline unsigned Bounds4::overlapping(const Bounds& one) const noexcept {
  using namespace lanes;
  Mask near = ~Mask{};
  for (std::size_t i = 0; i < 3; ++i) near &= (load(low_[i]) <= one.high[i]) & (load(high_[i]) >= one.low[i]);
  return bits_of(near);
}

inline unsigned Bounds4::meeting(const Bounds4& others) const noexcept {
  using namespace lanes;
  // All sixteen without a branch in between: which of them meet, a processor does not foresee.
  const std::array low{load(low_[0]), load(low_[1]), load(low_[2])},
      high{load(high_[0]), load(high_[1]), load(high_[2])};
  const auto overlapping = [&]<unsigned kLane>() {
    Mask near = ~Mask{};
    for (std::size_t i = 0; i < 3; ++i)
      near &=
          (low[i] <= all_of<kLane>(load(others.high_[i]))) & (high[i] >= all_of<kLane>(load(others.low_[i])));
    return bits_of(near) << 4 * kLane;
  };
  const unsigned overlaps = overlapping.template operator()<0>() | overlapping.template operator()<1>() |
                            overlapping.template operator()<2>() | overlapping.template operator()<3>();
  if (overlaps == 0) return 0;
  // Opposite as far as the angles of both cones together: cos(a + b) <= -axis . axis', or a + b is half a
  // turn or more.
  const std::array axis{load(axis_[0]), load(axis_[1]), load(axis_[2])};
  const Four cosine_a = load(cosine_), sine_a = load(sine_);
  const auto opposed = [&]<unsigned kLane>() {
    const Four cosine_b = all_of<kLane>(load(others.cosine_)), sine_b = all_of<kLane>(load(others.sine_));
    const Four cosine = cosine_b * cosine_a - sine_b * sine_a, sine = sine_b * cosine_a + cosine_b * sine_a;
    Four dot = axis[0] * all_of<kLane>(load(others.axis_[0]));
    dot += axis[1] * all_of<kLane>(load(others.axis_[1]));
    dot += axis[2] * all_of<kLane>(load(others.axis_[2]));
    const Mask half_a_turn = (sine < 0.0F) | ((sine <= kRoundOfCosine) & (cosine < 0.0F));
    return bits_of((cosine + dot <= kRoundOfCosine) | half_a_turn) << 4 * kLane;
  };
  return overlaps & (opposed.template operator()<0>() | opposed.template operator()<1>() |
                     opposed.template operator()<2>() | opposed.template operator()<3>());
}

}  // namespace fulcrum
