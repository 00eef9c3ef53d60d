#pragma once
// From levels to what a channel gets, once a tick, by one interface for all kinds.
//
// pcm: samples at the channel's own rate, carrier x envelope, as drive from -1 to 1. The envelope goes to
// each new level in a straight line, in the time that the command gives it, and never by more than kStep of
// I_max from one sample to the next; only where all force is being stopped does it take the time alone, and
// never rises. From nothing to the
// whole that is 100 samples: 2.1 ms at 48 kHz, and 100 ms at 1 kHz. A burst begins at phase 0.
//
// rumble, tone: one sample a tick, the amplitude as drive from 0 to 1.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "haptics/actuation/vibrotactile_actuator.h"
#include "haptics/device/vibrotactile_desc.h"
#include "haptics/signal/held_sine.h"

namespace fulcrum {

class ChannelOutput {
public:
  static constexpr double kStep = 0.01;  // of I_max

  ChannelOutput(const ChannelDesc& channel, const VibrotactileSignal& signal, double tick_s);

  // One tick: level (m/s^2) as VibrotactileCommand has it. Answers the drives of this tick; as many as there
  // are due, so none in some ticks of a slow channel. Allocates nothing.
  std::span<const double> process(double level, const VibrotactileCommand& command) noexcept;

  double rate_Hz() const { return rate_Hz_; }
  double envelope() const { return envelope_; }  // m/s^2, of the newest sample

private:
  double next() noexcept;

  ChannelKind kind_;
  double rate_Hz_, tick_s_;
  double full_;  // m/s^2, I_max
  double drive_per_level_;
  std::optional<HeldSine> carrier_;
  double level_ = 0, envelope_ = 0, step_ = 0;  // m/s^2; a sample
  std::int64_t ticks_ = 0, samples_ = 0;
  std::vector<double> drives_;
};

}  // namespace fulcrum
