#pragma once
// A resistance that is told at the fingertip: while the finger sweeps, a phantom moves between the two
// vibrators beside it, against the sweep. "Virtual vibrotactile motion as lateral force"; the levels are
// those of vibrotactile_law.h.
//
// `sweep`: along an axis of the scene, within `window` past a centre in the direction of the sweep, while the
// finger touches. Where the device pushes, a force may go with it,
//     F_lat = -sat(v / v_0) F_mag     along the axis, on the handle
// (Eq. 2 has no sign, and a bare sgn(v) would chatter.) It is a continuous force like any other, and goes
// with the vibration where that is switched off.
//
// `fallback`: for a device that cannot push. Along D's x, the line of its channels, while the handle goes
// against the force that it should feel: amplitude by that force, sat(|F| / full_force), and windows that
// follow one another along the way.
//
// Levels are updated at update_Hz from where the finger enters, every tick above kFast, and at once where it
// enters, leaves, turns round, rests or lifts off, and where a second onset comes later. Each update says in
// which time the envelope is to get there: until the next one. So edges are ramps of one update, and levels
// come as much late.

#include <optional>

#include "haptics/device/vibrotactile_desc.h"
#include "haptics/effects/vibrotactile_motion/sweep_direction.h"
#include "haptics/effects/vibrotactile_motion/vibrotactile_law.h"
#include "haptics/effects/vibrotactile_motion/vibrotactile_record.h"
#include "haptics/math/linear.h"
#include "haptics/math/mirror.h"
#include "haptics/math/names_of.h"
#include "haptics/signal/ramp.h"
#include "haptics/tick/command.h"

namespace fulcrum {

enum class VibrotactileUse { sweep, fallback };
template <>
inline constexpr std::array<std::string_view, 2> names_of<VibrotactileUse>{"sweep", "fallback"};

struct VibrotactileMotionDesc {
  VibrotactileUse use = VibrotactileUse::sweep;
  MotionLaw law;
  double strength = 1.31 * 9.8;  // m/s^2, I_max
  double update_Hz = 100;
  double carrier_Hz = 233;
  double gain = 1;               // of the levels; 0: named but off, the force too
  Vec3 centre_W = Vec3::Zero();  // (3) m, sweep
  Vec3 axis_W = Vec3::UnitX();   // (3), sweep: to the right of the finger; need not be unit
  double lateral_force = 0;      // N at the handle, sweep: F_mag
  double full_speed = 0.1;       // m/s, v_0
  double full_force = 1;         // N, fallback: at which the vibration is at its strongest
};

inline void mirror(VibrotactileMotionDesc& desc) {
  mirror(desc.centre_W);
  mirror_axis(desc.axis_W);  // to the right of the finger, whose vibrators stay where they are
}

class VibrotactileMotion {
public:
  static constexpr double kFast = 0.2;  // m/s, above which levels are updated every tick

  // channels: of the device; none: the force alone. position_scale: m of the scene for one of the handle.
  VibrotactileMotion(const VibrotactileMotionDesc& desc, const VibrotactileDesc* channels,
                     double position_scale, double tick_s);

  struct Tick {
    Vec3 p_WH, v_WH;   // (3) m; m/s, of the handle, which the finger is in
    double moved = 0;  // m, the handle's displacement in this tick along D's x
    double speed = 0;  // m/s, the handle's along D's x
    double felt = 0;   // N along D's x, of the force that the handle should feel
    bool touching = false;
    bool engaged = true;   // the hand holds the tool; false while clutched
    bool stopped = false;  // no force may be: levels stay what they were, and safety takes them down
  };
  // Answers the force on the handle (3) N, in W's axes as the device is to render it.
  Vec3 process(const Tick& tick) noexcept;

  // After process() and the guard: the levels, as much of them as safety lets through, 0 to 1.
  const VibrotactileCommand& render(double guard_gain, bool stopped) noexcept;

  void apply(const Command& command) noexcept;

  const VibrotactileMotionDesc& desc() const { return desc_; }
  const VibrotactileRecord& record() const { return record_; }

private:
  struct Place {
    double x = 0;      // m into the window
    double share = 0;  // of the strength; 0: nothing is told
    int direction = 0;
    double speed = 0;     // m/s
    bool begins = false;  // a window does
  };
  Place sweep(const Tick& tick) noexcept;
  Place fall_back(const Tick& tick) noexcept;
  void update(const Place& place) noexcept;

  VibrotactileMotionDesc desc_;
  double tick_s_;
  std::size_t left_ = 0, right_ = 0;
  std::size_t channels_ = 0;
  std::array<double, kMaxChannels> reach_{};  // (channels) m/s^2
  SweepDirection way_direction_;
  double way_ = 0, begin_ = 0;  // m, fallback: along D's x, and where the window began
  Ramp force_;

  int inside_ = 0;                                       // direction of the pass; 0: none
  double onset_ = 0;                                     // m, of the trailing vibrator in this pass
  bool second_ = false;                                  // it has begun after the other one
  double phase_ = 0;                                     // of the time between two updates
  bool changed_ = false;                                 // the gain was
  double left_share_ = 0, right_share_ = 0, glide_ = 0;  // of the strength; s, as of the last update
  VibrotactileRecord record_;
};

}  // namespace fulcrum
