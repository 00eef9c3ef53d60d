#pragma once
// The strip on a stick that knows where the hand holds it: a membrane potentiometer. A finger closes its two
// layers, and the resistance to that place grows linearly along it. Nothing presses: the circuit is open.
//
// Figures: 100 ohm to 10 kohm along the length, 0.5 to 1.8 N to actuate (from strip to strip, and from place
// to place). They are taken as hysteresis: above the upper one every strip is closed, below the lower one
// none.

#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "haptics/math/result.h"
#include "haptics/math/split_mix.h"

namespace fulcrum {

struct HoldingStripDesc {
  double low_place = 0.03;     // m along the stick from C, where the strip begins
  double high_place = 0.17;    // m, where it ends; above low_place
  double low_ohm = 100;        // ohm at low_place, as calibrated
  double high_ohm = 10000;     // ohm at high_place, as calibrated; not the same as low_ohm
  double closing_force = 1.8;  // N, a press from which on it is closed
  double opening_force = 0.5;  // N, a press below which it is open again

  // Of the simulated strip alone:
  double noise_ohm = 10;        // rms
  double dropout_rate = 0;      // 1/s, how often contact is lost though the finger presses
  double dropout_length = 0.1;  // s, mean
  double tolerance = 0;  // of its resistance from end to end, by which its true ends differ at most from
                         // those it was calibrated to
};

// What is wrong with its figures, if anything.
std::optional<Error> refuse_strip(const HoldingStripDesc& strip);

// m along the stick, of a resistance in ohm; not finite where that is not.
double place_of(const HoldingStripDesc& strip, double ohm);

// Resistances in ohm, as DeviceSample::strip_ohm gives them.
inline constexpr double kNoStrip = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kStripOpen = std::numeric_limits<double>::infinity();

// A strip of its own tolerance, noise and bad contacts: the same for the same seed.
class SimulatedStrip {
public:
  SimulatedStrip(const HoldingStripDesc& desc, double tick_s, std::uint64_t seed);

  // One tick on: ohm, pressed at `place` (m along the stick) with `press` (N). Beside the strip nothing
  // closes it.
  double advance(double place, double press) noexcept;

  // What a calibration of this strip finds; see fit_strip.
  double true_low_ohm() const { return low_ohm_; }
  double true_high_ohm() const { return high_ohm_; }

private:
  bool drops_out() noexcept;

  HoldingStripDesc desc_;
  double tick_s_;
  SplitMix random_;
  double low_ohm_, high_ohm_;
  bool closed_ = false;
  double dropout_left_ = 0;  // s
};

// A finger at a known place, and what the strip said.
struct StripPress {
  double place = 0;  // m along the stick
  double ohm = 0;
};

struct StripFit {
  double low_ohm = 0, high_ohm = 0;  // at the strip's ends
  double residual_ohm = 0;           // rms, of the presses about the line
  double residual = 0;               // m rms along the stick, the same
};

// The line through presses at known places, by least squares. Nothing where it cannot be told: fewer than two
// places that differ, numbers that are not finite, or a line along which resistance does not change.
std::optional<StripFit> fit_strip(const HoldingStripDesc& strip, std::span<const StripPress> presses);

}  // namespace fulcrum
