#pragma once
// How a vibration tells the distance from the hand to the impact: g(r, t) = sum_n a_n(r) e^(-d t) sin(2 pi
// f_n(r) t). J. Sreng, A. Lecuyer, C. Andriot, B. Arnaldi, "Spatialized haptic rendering: providing impact
// position information in 6DOF haptic simulations using vibrations", IEEE Virtual Reality 2009, Eqs. 1 and 2.
//
// beam: an Euler-Bernoulli beam of the length of the tool's reach, clamped in the hand and free at its end. A
// blow at r excites mode n by its shape there, and all modes turn the clamp alike for it:
//     a_n = phi_n(r) / 2,     f_n = f (beta_n / beta_1)^2,    f_1 the material's
//     phi_n(x) = cosh b x - cos b x - s_n (sinh b x - sin b x),   b = beta_n / L,
//     beta_n the roots of cosh(b) cos(b) = -1,   s_n = (cosh beta_n + cos beta_n) / (sinh beta_n + sin
//     beta_n)
// (S. S. Rao, "Vibration of Continuous Systems", 2007, ch. 11). Beside the hand a beam is silent; here the
// first mode keeps a tenth.
//
// sinusoid: one tone whose frequency falls with r from the material's to 12 Hz, the lowest that was tried:
//     f_1 = 12 + (f - 12)(1 - r / L), never below 12 Hz, so that a blow on the free end is heard as well
// The printed Eq. 2 has lost its typography; this is its c (L - x_0) t with a floor.

#include <array>
#include <cstddef>

#include "haptics/math/names_of.h"

namespace fulcrum {

enum class DistanceModel { beam, sinusoid };
template <>
inline constexpr std::array<std::string_view, 2> names_of<DistanceModel>{"beam", "sinusoid"};

struct VibrationModes {
  static constexpr std::size_t kMax = 3;
  struct Mode {
    double frequency_Hz = 0;
    double amplitude = 0;  // of 1; its sign is its phase
  };
  std::array<Mode, kMax> modes{};
  std::size_t count = 0;
};

// frequency_Hz: the material's. r, reach m: from the hand to the impact, and to the farthest point of the
// tool; an r beyond it counts as reach.
VibrationModes vibration_modes(DistanceModel model, double frequency_Hz, double r, double reach) noexcept;

}  // namespace fulcrum
