#pragma once
// How strong the two vibrators beside a finger are while a phantom goes from one to the other: "Virtual
// vibrotactile motion as lateral force", Eqs. 3 to 5, by the way x that the finger has gone into the window,
// 0 to d_max, towards one side. On the side that it goes to the vibrator is `leading`, the other one
// `trailing`: the phantom goes from the first to the second, against the sweep.
//     linear        trailing  x / d_max                                    leading  the same of d_max - x
//     logarithmic   trailing  log(1 + x/x_ref) / log(1 + d_max/x_ref)      the same of d_max - x
// in shares of I_max. The paper's log(x + 1) has an x_ref of one unit of length, and it matters: half way the
// level is .747 with 1 mm, .585 with 1 cm, .501 with 1 m.
//
// Onset-asynchronous: both start together above. With Eq. 3 the second onset comes
//     SOA = 0.32 T_s + 0.0473 s
// after the first, T_s = d_max / v the duration of the signals. Here levels go by place, so v is what it is
// where the finger enters, and the second vibrator begins SOA v into the window and rises by the same law
// over what is left of it. That needs SOA < T_s: T_s > 69.56 ms, or 0.144 m/s at most with 10 mm. On a faster
// pass there would be nothing left of the window: both start together then.

#include "haptics/math/names_of.h"

namespace fulcrum {

enum class MotionEnvelope { linear, logarithmic };
template <>
inline constexpr std::array<std::string_view, 2> names_of<MotionEnvelope>{"linear", "logarithmic"};

enum class MotionOnset { together, asynchronous };
template <>
inline constexpr std::array<std::string_view, 2> names_of<MotionOnset>{"together", "asynchronous"};

struct MotionLaw {
  MotionEnvelope envelope = MotionEnvelope::logarithmic;
  MotionOnset onset = MotionOnset::together;
  double window = 10e-3;    // m, d_max
  double reference = 1e-3;  // m, x_ref
};

// 0 to 1.
struct MotionLevels {
  double leading = 0, trailing = 0;
};

// Share of I_max at x of `window` m.
double motion_envelope(const MotionLaw& law, double x, double window) noexcept;

inline constexpr double kSoaPart = 0.32;    // of T_s
inline constexpr double kSoaBase = 0.0473;  // s

// m into the window, where the trailing vibrator begins on a pass entered at `speed` m/s.
double trailing_onset(const MotionLaw& law, double speed) noexcept;

// x (m): 0 to d_max; outside nothing. onset (m): trailing_onset() of this pass.
MotionLevels motion_levels(const MotionLaw& law, double x, double onset) noexcept;

}  // namespace fulcrum
