#include "haptics/actuation/vibrotactile_actuator.h"

#include <cmath>
#include <numbers>

#include "haptics/signal/held_sine.h"

namespace fulcrum {

double actuator_response(const ChannelDesc& channel, double frequency_Hz) noexcept {
  if (channel.kind == ChannelKind::rumble) return 1;
  const double r = frequency_Hz / channel.resonance_Hz;
  return r * r / std::hypot(channel.quality * (1 - r * r), r);
}

double actuator_reach(const ChannelDesc& channel, double carrier_Hz) noexcept {
  const double full = channel.largest * actuator_response(channel, carrier_Hz);
  return channel.kind == ChannelKind::rumble ? full
                                             : full / HeldSine(carrier_Hz, 1 / channel.rate_Hz).largest();
}

VibrotactileActuator::VibrotactileActuator(const ChannelDesc& channel, double step_s)
    : kind_(channel.kind), largest_(channel.largest) {
  if (kind_ == ChannelKind::rumble) {
    keep_ = channel.lag > 0 ? std::exp(-step_s / channel.lag) : 0.0;
    return;
  }
  w_ = 2 * std::numbers::pi * channel.resonance_Hz;
  out_ = largest_ / (channel.quality * step_s);
  const double decay = 0.5 * w_ / channel.quality, w_d = std::sqrt(w_ * w_ - decay * decay);
  const double kept = std::exp(-decay * step_s), c = std::cos(w_d * step_s), s = std::sin(w_d * step_s) / w_d;
  xx_ = kept * (c + decay * s);
  xv_ = kept * s;
  vx_ = -kept * w_ * w_ * s;
  vv_ = kept * (c - decay * s);
}

double VibrotactileActuator::advance(double drive) noexcept {
  if (kind_ == ChannelKind::rumble) {
    amplitude_ = drive + keep_ * (amplitude_ - drive);
    return largest_ * amplitude_;
  }
  const double rest = drive / (w_ * w_), x = x_ - rest, v = v_;
  x_ = rest + xx_ * x + xv_ * v;
  v_ = vx_ * x + vv_ * v;
  return out_ * (v_ - v);
}

}  // namespace fulcrum
