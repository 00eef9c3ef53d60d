#pragma once
// A vibrator in time: how it answers to its drive, from sample to sample and exactly, for a drive that is
// held between two (the closed forms of the damped oscillator of vibrotactile_actuator.h, and of a lag).

#include <cmath>
#include <numbers>

#include "haptics/device/vibrotactile_desc.h"

namespace fulcrum::test {

class SimulatedVibrator {
public:
  // step_s: s between two drives.
  SimulatedVibrator(const ChannelDesc& channel, double step_s)
      : kind_(channel.kind), largest_(channel.largest) {
    if (kind_ != ChannelKind::pcm) {
      keep_ = channel.lag > 0 ? std::exp(-step_s / channel.lag) : 0.0;
      return;
    }
    w_ = 2 * std::numbers::pi * channel.resonance_Hz;
    out_ = largest_ / (channel.quality * step_s);
    const double decay = 0.5 * w_ / channel.quality, w_d = std::sqrt(w_ * w_ - decay * decay);
    const double kept = std::exp(-decay * step_s), c = std::cos(w_d * step_s),
                 s = std::sin(w_d * step_s) / w_d;
    xx_ = kept * (c + decay * s);
    xv_ = kept * s;
    vx_ = -kept * w_ * w_ * s;
    vv_ = kept * (c - decay * s);
  }

  // The drive of the next step. Answers, of pcm: the step's mean acceleration, m/s^2; of rumble: the
  // amplitude at its end.
  double advance(double drive) noexcept {
    if (kind_ != ChannelKind::pcm) {
      amplitude_ = drive + keep_ * (amplitude_ - drive);
      return largest_ * amplitude_;
    }
    const double rest = drive / (w_ * w_), x = x_ - rest, v = v_;
    x_ = rest + xx_ * x + xv_ * v;
    v_ = vx_ * x + vv_ * v;
    return out_ * (v_ - v);
  }

private:
  ChannelKind kind_;
  double largest_;
  double keep_ = 0;                           // rumble: of the amplitude, each step
  double amplitude_ = 0;                      // rumble: share
  double w_ = 0;                              // rad/s
  double xx_ = 0, xv_ = 0, vx_ = 0, vv_ = 0;  // free motion over a step, from (x, v) to (x, v)
  double x_ = 0, v_ = 0;                      // of a drive of 1
  double out_ = 0;                            // m/s^2, of a change of v by 1
};

}  // namespace fulcrum::test
