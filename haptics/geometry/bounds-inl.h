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

inline unsigned Bounds4::meeting(const Bounds& one) const noexcept {
  using namespace lanes;
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
