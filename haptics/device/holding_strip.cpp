#include "haptics/device/holding_strip.h"

#include <algorithm>
#include <cmath>

#include "haptics/math/functions.h"

namespace fulcrum {

std::optional<Error> refuse_strip(const HoldingStripDesc& strip) {
  if (!(strip.low_place < strip.high_place))
    return Error{"The device's strip has no length: give it a high_place beyond its low_place."};
  if (strip.low_ohm == strip.high_ohm)
    return Error{"The device's strip has the same resistance at both ends: give it two that differ."};
  if (!(strip.opening_force <= strip.closing_force))
    return Error{
        "The device's strip opens at a press that it does not close at: give it an opening_force of at most "
        "its closing_force."};
  return std::nullopt;
}

double place_of(const HoldingStripDesc& strip, double ohm) {
  const double along = (ohm - strip.low_ohm) / (strip.high_ohm - strip.low_ohm);
  return strip.low_place + along * (strip.high_place - strip.low_place);
}

SimulatedStrip::SimulatedStrip(const HoldingStripDesc& desc, double tick_s, std::uint64_t seed)
    : desc_(desc), tick_s_(tick_s), random_(seed) {
  const double most = desc.tolerance * (desc.high_ohm - desc.low_ohm);
  low_ohm_ = std::max(0.0, desc.low_ohm + most * (2 * random_.uniform() - 1));
  high_ohm_ = std::max(0.0, desc.high_ohm + most * (2 * random_.uniform() - 1));
}

double SimulatedStrip::advance(double place, double press) noexcept {
  // Drawn whether they are needed or not: what the finger does changes no later draw.
  const double noise = desc_.noise_ohm * random_.normal();
  const bool dropped = drops_out();
  closed_ = closed_ ? press >= desc_.opening_force : press >= desc_.closing_force;
  const bool beside = !(place >= desc_.low_place && place <= desc_.high_place);
  if (!closed_ || beside || dropped) return kStripOpen;
  const double along = (place - desc_.low_place) / (desc_.high_place - desc_.low_place);
  return std::max(0.0, low_ohm_ + along * (high_ohm_ - low_ohm_) + noise);
}

bool SimulatedStrip::drops_out() noexcept {
  const double begins = random_.uniform(), length = -math::log1p(-random_.uniform()) * desc_.dropout_length;
  if (dropout_left_ > 0)
    dropout_left_ -= tick_s_;
  else if (begins < -math::expm1(-desc_.dropout_rate * tick_s_))
    dropout_left_ = length;
  return dropout_left_ > 0;
}

std::optional<StripFit> fit_strip(const HoldingStripDesc& strip, std::span<const StripPress> presses) {
  const auto n = static_cast<double>(presses.size());
  double mean_place = 0, mean_ohm = 0;
  for (const StripPress& press : presses) {
    mean_place += press.place / n;
    mean_ohm += press.ohm / n;
  }
  double spread = 0, together = 0;
  for (const StripPress& press : presses) {
    spread += math::square(press.place - mean_place);
    together += (press.place - mean_place) * (press.ohm - mean_ohm);
  }
  const double slope = together / spread;  // ohm/m
  if (!std::isfinite(slope) || slope == 0) return std::nullopt;
  StripFit fit;
  fit.low_ohm = mean_ohm + slope * (strip.low_place - mean_place);
  fit.high_ohm = mean_ohm + slope * (strip.high_place - mean_place);
  double squares = 0;
  for (const StripPress& press : presses)
    squares += math::square(press.ohm - (mean_ohm + slope * (press.place - mean_place)));
  fit.residual_ohm = std::sqrt(squares / n);
  fit.residual = fit.residual_ohm / std::abs(slope);
  return fit;
}

}  // namespace fulcrum
