#pragma once
// A vibrator as a model: what of a wanted acceleration it can give, and how it answers to its drive, -1 to 1.
//
// A voice coil's moving mass m on its spring, driven by a force in proportion to the drive u, shakes its
// housing with the mass's own acceleration:
//     x'' + (w_0/Q) x' + w_0^2 x = u,     a = (A/Q) x''
// so that a full drive at the resonance gives A (`largest`) and one at f
//     |H(f)| A = A r^2 / sqrt( (Q (1 - r^2))^2 + r^2 ),     r = f/f_0
// It is taken from sample to sample exactly, for a drive that is held between two (the closed form of the
// damped oscillator). Near its resonance it needs Q / (pi f_0) s to swell, 4 ms at Q = 3 and 233 Hz.
//
// A rumble motor turns an eccentric mass: its amplitude follows the drive with a first-order lag, at a
// frequency that follows its speed and that nobody can choose.

#include "haptics/device/vibrotactile_desc.h"

namespace fulcrum {

// Of the acceleration at the resonance with the same drive; of a rumble motor 1.
double actuator_response(const ChannelDesc& channel, double frequency_Hz) noexcept;

// m/s^2, the largest amplitude that the channel can be asked for. A pcm channel holds each sample and gets
// them made larger for it (signal/held_sine.h), which leaves that much less.
double actuator_reach(const ChannelDesc& channel, double carrier_Hz) noexcept;

class VibrotactileActuator {
public:
  // step_s: s between two drives.
  VibrotactileActuator(const ChannelDesc& channel, double step_s);

  // The drive of the next step. Answers, of pcm: the step's mean acceleration, m/s^2; of rumble: the
  // amplitude at its end.
  double advance(double drive) noexcept;

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

}  // namespace fulcrum
