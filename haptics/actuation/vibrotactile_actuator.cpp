#include "haptics/actuation/vibrotactile_actuator.h"

#include "haptics/math/functions.h"
#include "haptics/signal/held_sine.h"

namespace fulcrum {

double actuator_response(const ChannelDesc& channel, double frequency_Hz) noexcept {
  if (channel.kind != ChannelKind::pcm) return 1;
  const double r = frequency_Hz / channel.resonance_Hz;
  return r * r / math::hypot(channel.quality * (1 - r * r), r);
}

double actuator_reach(const ChannelDesc& channel, double carrier_Hz) noexcept {
  const double full = channel.largest * actuator_response(channel, carrier_Hz);
  return channel.kind == ChannelKind::pcm ? full / HeldSine(carrier_Hz, 1 / channel.rate_Hz).largest() : full;
}

}  // namespace fulcrum
