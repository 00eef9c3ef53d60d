#pragma once
// A vibrator as a model: what of a wanted acceleration it can give, and so which drive, -1 to 1, a level
// needs.
//
// A voice coil's moving mass m on its spring, driven by a force in proportion to the drive u, shakes its
// housing with the mass's own acceleration:
//     x'' + (w_0/Q) x' + w_0^2 x = u,     a = (A/Q) x''
// so that a full drive at the resonance gives A (`largest`) and one at f
//     |H(f)| A = A r^2 / sqrt( (Q (1 - r^2))^2 + r^2 ),     r = f/f_0
// once it has swollen, which near its resonance takes Q / (pi f_0) s, 4 ms at Q = 3 and 233 Hz.
//
// A rumble motor turns an eccentric mass: its amplitude follows the drive with a first-order lag, at a
// frequency that follows its speed and that nobody can choose. One that is told a tone makes the frequency
// by itself; its amplitude is taken to follow in the same way, as strongly at any carrier.

#include "haptics/device/vibrotactile_desc.h"

namespace fulcrum {

// Of the acceleration at the resonance with the same drive; of what is no pcm 1.
double actuator_response(const ChannelDesc& channel, double frequency_Hz) noexcept;

// m/s^2, the largest amplitude that the channel can be asked for. A pcm channel holds each sample and gets
// them made larger for it (signal/held_sine.h), which leaves that much less.
double actuator_reach(const ChannelDesc& channel, double carrier_Hz) noexcept;

}  // namespace fulcrum
