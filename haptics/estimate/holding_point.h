#pragma once
// Where along the stick the hand holds it: told, or measured by a strip. A place that is measured is trusted
// once the reading is on the strip and has kept still; a reading that is lost leaves the last trusted place
// for a while, and then the place fades to the default. It stays from `low` to `high` and never moves faster
// than `speed`, whatever moves it: the wrench that is rendered about it cannot step.

#include <optional>

#include "haptics/device/holding_strip.h"
#include "haptics/math/linear.h"

namespace fulcrum {

struct HoldingPointDesc {
  Vec3 axis_H = Vec3::UnitX();  // (3) unit, along the stick from C, the handle's origin
  double place = 0;             // m along it, the default: where the hand holds as long as no more is known
  double low = 0, high = 0.2;   // m along it: the ends of where it can be held
  bool measured = true;         // at the start; the device's strip says where
  double speed = 0.2;           // m/s, fastest that the place moves
  double settle = 0.02;         // s, for which a reading must keep still to be trusted
  double stillness = 0.002;     // m a tick, the most that a reading that keeps still moves
  double margin = 0.003;        // m, beyond the strip's ends, that a reading may be off
  double smoothing = 0.01;      // s, of what is read
  double keep = 0.5;            // s, for which the last trusted place is kept once the reading is lost
  double fade = 1;              // s, in which it then goes to the default
};

enum class HoldingState {
  set,       // told, not measured
  measured,  // read from the strip
  kept,      // lost: the last trusted place
  fading,    // lost: on the way to the default
  lost       // there, though it is to be measured
};

class HoldingPoint {
public:
  // strip: the device's, if it has one. tick_s: s.
  HoldingPoint(const HoldingPointDesc& desc, const std::optional<HoldingStripDesc>& strip, double tick_s);

  void tell(double place) noexcept;  // m along the stick; not finite: ignored
  void measure(bool on) noexcept { measure_ = on; }

  // Called once a tick: ohm, as DeviceSample::strip_ohm. Any number at all.
  void update(double strip_ohm) noexcept;

  double place() const { return place_; }              // m along the stick
  Vec3 p_HG() const { return place_ * desc_.axis_H; }  // (3) m, in H
  HoldingState state() const { return state_; }

private:
  bool trusted(double reading) noexcept;
  double wanted(double reading) noexcept;

  HoldingPointDesc desc_;
  std::optional<HoldingStripDesc> strip_;
  double tick_s_;
  bool measure_;
  double told_, place_;
  HoldingState state_;
  std::optional<double> reading_;  // m, the last that was on the strip
  double still_ = 0;               // s, for which it has kept still
  std::optional<double> smooth_;   // m, smoothed while it is trusted
  double last_trusted_;            // m
  double lost_for_;                // s, since it was
};

}  // namespace fulcrum
