#pragma once
// y(t) = e^(-d t) sin(2 pi f t), sampled at the ticks, by its exact recursion:
//     y_n = 2 e^(-d T) cos(w T) y_(n-1) - e^(-2 d T) y_(n-2),     w = 2 pi f,  y_0 = 0,  y_(-1) = -e^(d T)
//     sin(w T)
// No integrator comes near it: semi-implicit Euler at 1 kHz is 0.016 off at 12 Hz, and useless at 200. Held
// for a tick, as a device holds it, it comes half a tick late; the amplitude that the hold takes away, f T =
// 0.04 or less for what shakes a hand, is 0.3 % at most and stays away.

#include <numbers>

#include "haptics/math/functions.h"

namespace fulcrum {

class DecayingSine {
public:
  DecayingSine() = default;  // silence
  // decay: 1/s.
  DecayingSine(double frequency_Hz, double decay, double tick_s) {
    const double turn = 2 * std::numbers::pi * frequency_Hz * tick_s;
    const double kept = math::exp(-decay * tick_s);
    of_last_ = 2 * kept * math::cos(turn);
    of_before_ = kept * kept;
    before_ = -math::sin(turn) / kept;
  }

  // y_1 first, then y_2, and so on.
  double next() noexcept {
    const double y = of_last_ * last_ - of_before_ * before_;
    before_ = last_;
    last_ = y;
    return y;
  }

private:
  double of_last_ = 0, of_before_ = 0;
  double last_ = 0, before_ = 0;
};

}  // namespace fulcrum
