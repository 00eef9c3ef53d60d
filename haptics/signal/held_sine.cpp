#include "haptics/signal/held_sine.h"

#include <cmath>
#include <numbers>

#include "haptics/math/functions.h"

namespace fulcrum {

HeldSine::HeldSine(double frequency_Hz, double tick_s) : turns_per_tick_(frequency_Hz * tick_s) {
  const double x = std::numbers::pi * turns_per_tick_;
  peak_ = x / math::sin(x);
}

double HeldSine::next() noexcept {
  const double sample = peak_ * math::sin(2 * std::numbers::pi * turns_);
  turns_ += turns_per_tick_;
  turns_ -= std::floor(turns_);
  return sample;
}

}  // namespace fulcrum
