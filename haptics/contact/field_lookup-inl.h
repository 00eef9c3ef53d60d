// Trilinear look-up of several points at once in a FieldView; compiled once for each SIMD target.

#if defined(FULCRUM_FIELD_LOOKUP_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FULCRUM_FIELD_LOOKUP_INL_H
#undef FULCRUM_FIELD_LOOKUP_INL_H
#else
#define FULCRUM_FIELD_LOOKUP_INL_H
#endif

#include <cstdint>
#include <cstring>

#include "haptics/geometry/field_view.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace fulcrum::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, 16>;
using Ints = hn::RebindToSigned<Floats>;
using F = hn::Vec<Floats>;
using I = hn::Vec<Ints>;
using M = hn::Mask<Floats>;
constexpr Floats f{};
constexpr Ints n{};

// 32 bits at each byte offset, which need not be aligned.
HWY_INLINE I gather(const void* base, I offset) {
#if HWY_ARCH_X86 && HWY_TARGET <= HWY_AVX2
  return hn::GatherOffset(n, static_cast<const std::int32_t*>(base), offset);
#else
  HWY_ALIGN std::int32_t at[16];
  hn::Store(offset, n, at);
  for (std::size_t i = 0; i < hn::Lanes(n); ++i)
    std::memcpy(&at[i], static_cast<const char*>(base) + at[i], sizeof at[i]);
  return hn::Load(n, at);
#endif
}

HWY_INLINE std::uint32_t bits_of(M mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(f, mask, bytes);
  return static_cast<std::uint32_t>(bytes[0] | bytes[1] << 8);
}

HWY_INLINE F mix(F a, F b, F t) {
  return hn::Add(a, hn::Mul(hn::Sub(b, a), t));
}

// Two neighbours along x from where `offset` counts in values.
HWY_INLINE void load_pair(const std::int16_t* values, I offset, F& low, F& high) {
  const I both = gather(values, hn::ShiftLeft<1>(offset));
  low = hn::ConvertTo(f, hn::ShiftRight<16>(hn::ShiftLeft<16>(both)));
  high = hn::ConvertTo(f, hn::ShiftRight<16>(both));
}
HWY_INLINE void load_pair(const float* values, I offset, F& low, F& high) {
  const I bytes = hn::ShiftLeft<2>(offset);
  low = hn::BitCast(f, gather(values, bytes));
  high = hn::BitCast(f, gather(values + 1, bytes));
}

struct Place {
  F x, y, z;  // cells from `from`
  std::array<std::int32_t, 3> from;
};

// Where `stored`: the interpolant's terms. Elsewhere they mean nothing.
struct Terms {
  M in_grid;
  I brick;  // of the place, where in the grid: its number times four
  M stored;
  F tx, ty, tz;       // 0 to 1 within the cell
  F low[4], high[4];  // the corners at both ends of x, in quanta; y fastest
  F along_x[4];       // interpolated along x
};

HWY_INLINE F length(F x, F y, F z) {
  return hn::Sqrt(hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z)));
}

// The solid's bounds are no farther than its surface. Not a number: far outside. p: cells.
HWY_INLINE F distance_to_bounds(const FieldView& field, F x, F y, F z) {
  const auto beyond = [](F q, float low, float high) {
    return hn::Sub(q, hn::Min(hn::Max(q, hn::Set(f, low)), hn::Set(f, high)));
  };
  const F far = hn::Set(f, static_cast<float>(kFarOutside_m));
  const F distance = hn::Mul(
      length(beyond(x, field.box_low[0], field.box_high[0]), beyond(y, field.box_low[1], field.box_high[1]),
             beyond(z, field.box_low[2], field.box_high[2])),
      hn::Set(f, field.voxel_m));
  const F number = hn::Add(hn::Add(x, y), z);
  return hn::IfThenElse(hn::And(hn::Lt(distance, far), hn::Eq(number, number)), distance, far);
}

// Distance in m, and what its gradient is made of.
template <class Value>
HWY_INLINE F look_up(const FieldView& field, const Place& p, Terms& terms) {
  const F zero = hn::Zero(f);
  const auto within = [&](F q, float cells) {
    return hn::And(hn::Ge(q, zero), hn::Le(q, hn::Set(f, cells)));  // false for NaN
  };
  const auto whole = [](F coordinate, std::int32_t from) {
    return hn::Add(coordinate, hn::Set(f, static_cast<float>(from)));
  };
  const F wx = whole(p.x, p.from[0]), wy = whole(p.y, p.from[1]), wz = whole(p.z, p.from[2]);
  const M in_grid =
      hn::And(hn::And(within(wx, field.cells[0]), within(wy, field.cells[1])), within(wz, field.cells[2]));
  terms.in_grid = in_grid;
  if (hn::AllFalse(f, in_grid)) {
    terms.brick = hn::Zero(n);
    terms.stored = in_grid;
    return distance_to_bounds(field, wx, wy, wz);
  }
  const F px = hn::IfThenElseZero(in_grid, p.x), py = hn::IfThenElseZero(in_grid, p.y),
          pz = hn::IfThenElseZero(in_grid, p.z);
  const auto cell_of = [](F coordinate, std::int32_t from, std::int32_t bricks) {
    const I cell = hn::Add(hn::ConvertTo(n, hn::Floor(coordinate)), hn::Set(n, from));
    return hn::Min(hn::Max(cell, hn::Zero(n)), hn::Set(n, bricks * kBrickCells - 1));
  };
  const I x = cell_of(px, p.from[0], field.bricks[0]), y = cell_of(py, p.from[1], field.bricks[1]),
          z = cell_of(pz, p.from[2], field.bricks[2]);
  const I bx = hn::ShiftRight<3>(x), by = hn::ShiftRight<3>(y), bz = hn::ShiftRight<3>(z);
  const I row = hn::Add(hn::Mul(bz, hn::Set(n, field.bricks[1])), by);
  const I brick = hn::ShiftLeft<2>(hn::Add(hn::Mul(row, hn::Set(n, field.bricks[0])), bx));
  terms.brick = brick;
  const I slot = gather(field.brick_slot, brick);
  const M has_values = hn::RebindMask(f, hn::Gt(slot, hn::Set(n, kNoBrick)));
  terms.stored = hn::And(in_grid, has_values);

  F distance = zero;
  if (!hn::AllFalse(f, terms.stored)) {
    const auto rest = [](F coordinate, I cell, std::int32_t from) {
      return hn::Sub(coordinate, hn::ConvertTo(f, hn::Sub(cell, hn::Set(n, from))));
    };
    terms.tx = rest(px, x, p.from[0]);
    terms.ty = rest(py, y, p.from[1]);
    terms.tz = rest(pz, z, p.from[2]);
    const I seven = hn::Set(n, kBrickCells - 1);
    const I in_brick =
        hn::Add(hn::And(x, seven),
                hn::Mul(hn::Add(hn::And(y, seven), hn::Mul(hn::And(z, seven), hn::Set(n, kBrickSide))),
                        hn::Set(n, kBrickSide)));
    const I start = hn::Max(slot, hn::Zero(n));
    const I lowest = hn::Add(hn::Mul(start, hn::Set(n, kBrickValues)), in_brick);
    const auto* values = static_cast<const Value*>(field.values);
    constexpr int kSteps[4] = {0, kBrickSide, kBrickSide * kBrickSide, kBrickSide * kBrickSide + kBrickSide};
    for (int i = 0; i < 4; ++i) {
      load_pair(values + kSteps[i], lowest, terms.low[i], terms.high[i]);
      terms.along_x[i] = mix(terms.low[i], terms.high[i], terms.tx);
    }
    distance = hn::Mul(mix(mix(terms.along_x[0], terms.along_x[1], terms.ty),
                           mix(terms.along_x[2], terms.along_x[3], terms.ty), terms.tz),
                       hn::Set(f, field.quantum_m));
  }
  if (hn::AllTrue(f, terms.stored)) return distance;

  // The brick's centre, less the way from there.
  const F centre = hn::BitCast(f, gather(field.centre_m, brick));
  const auto from_middle = [](F coordinate, I b) {
    const I middle = hn::Add(hn::ShiftLeft<3>(b), hn::Set(n, kBrickCells / 2));
    return hn::Sub(coordinate, hn::ConvertTo(f, middle));
  };
  const F way = hn::Mul(length(from_middle(wx, bx), from_middle(wy, by), from_middle(wz, bz)),
                        hn::Set(f, field.voxel_m));
  const F least = hn::Max(hn::Sub(hn::Abs(centre), way), hn::Set(f, field.band_m));
  const F coarse = hn::CopySign(least, centre);
  return hn::IfThenElse(
      terms.stored, distance,
      hn::IfThenElse(in_grid, coarse,
                     hn::AllTrue(f, in_grid) ? zero : distance_to_bounds(field, wx, wy, wz)));
}

constexpr float kFlat = 1e-3f;  // of the gradient that a distance has

// The interpolant's gradient, made unit. Answers where there is one.
HWY_INLINE M unit_gradient(const FieldView& field, const Terms& terms, F& nx, F& ny, F& nz) {
  const auto slope = [&](int i) { return hn::Sub(terms.high[i], terms.low[i]); };
  const F* v = terms.along_x;
  const F gx = mix(mix(slope(0), slope(1), terms.ty), mix(slope(2), slope(3), terms.ty), terms.tz);
  const F gy = mix(hn::Sub(v[1], v[0]), hn::Sub(v[3], v[2]), terms.tz);
  const F gz = hn::Sub(mix(v[2], v[3], terms.ty), mix(v[0], v[1], terms.ty));
  const F size = length(gx, gy, gz);
  const M steep = hn::And(terms.stored, hn::Gt(size, hn::Set(f, kFlat * field.voxel_m / field.quantum_m)));
  const F divisor = hn::IfThenElse(steep, size, hn::Set(f, 1.0f));
  nx = hn::Div(gx, divisor);
  ny = hn::Div(gy, divisor);
  nz = hn::Div(gz, divisor);
  return steep;
}

}  // namespace fulcrum::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
