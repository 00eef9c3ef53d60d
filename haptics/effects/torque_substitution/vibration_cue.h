#pragma once
// A tone on the handle whose strength tells of a torque:
//     F_p = A sat( log(1 + |tau| / tau_0) / log(1 + tau_max / tau_0) ) sin(2 pi f t) d
// added after the coupling and never fed to the tool.
//
// The direction d is at right angles to the force that the hand feels. It then neither presses the tool on
// what it touches nor lifts it off; with force and tone at right angles, the sum is longer than the force by
// A^2 / 2F alone, which leaves the motors their room; and a tone is felt alike from every direction, so that
// nothing is lost by the choice (N. Landin, J. Romano, W. McMahan, K. Kuchenbecker, "Dimensional reduction of
// high-frequency accelerations for haptic rendering", EuroHaptics 2010). It turns with the force slowly, over
// kTurn, and shrinks on the way where it has to swing round: a direction that jumped would click.
//
// The tone starts at phase 0 and swells and fades over kSwell: no click at either end.

#include "haptics/math/linear.h"
#include "haptics/signal/held_sine.h"
#include "haptics/signal/ramp.h"

namespace fulcrum {

struct VibrationDesc {
  double amplitude = 0.4;     // N at the handle, at tau_max and gain 1
  double frequency_Hz = 200;  // where fingers are most sensitive
  double reference = 0;       // N m, tau_0: below it strength grows in proportion, above with the logarithm
  double largest = 0;         // N m, tau_max
};

class VibrationCue {
public:
  static constexpr double kSwell = 20e-3;  // s, from nothing to the whole amplitude
  static constexpr double kTurn = 50e-3;   // s, time constant

  VibrationCue(const VibrationDesc& desc, double tick_s);

  // level: 0 to 1, see strength(). felt_D (3) N: the continuous force on the handle, in D. Answers the force
  // of this tick (3) N, in D.
  Vec3 process(double level, const Vec3& felt_D) noexcept;

  // 0 to 1: the saturated logarithm of a torque, N m.
  double strength(double torque) const noexcept;
  double amplitude() const { return desc_.amplitude * ramp_.level(); }  // N, of the tone now

private:
  void turn(const Vec3& felt_D) noexcept;

  VibrationDesc desc_;
  HeldSine sine_;
  Ramp ramp_;
  double turning_;                  // share of the way to the wanted direction, each tick
  Vec3 wanted_D_ = Vec3::UnitX();   // (3) unit
  Vec3 direction_ = Vec3::UnitX();  // (3) at most unit, in D
};

}  // namespace fulcrum
