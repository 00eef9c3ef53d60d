#pragma once
// Makes up for a device's own mass m at its distal stage C, the handle's origin, which a hand that holds a
// stick elsewhere, at G, feels beside what is rendered: f_h = f - m a, tau_h = h x f + (l - h) x m a, with l
// and h the vectors from C and from G to the contact. "Compensating device inertia for 6-DOF haptic
// rendering", III; its Eqs. 7b and 11 have other signs, which overcorrect. By name:
//     none
//     arm           while the contact lies between hand and stage: torque h x f about C in place of l x f
//     acceleration  force f + g m a, torque unchanged: with g = 1 the hand feels f and h x f exactly; what
//                   the handle's inertia takes to turn remains
// a comes of a Kalman filter, and lags. m a that is late adds energy to what the hand moves to and fro; of a
// hand of mass M and damping B on a wall k that holds up to a lag of about M B / (g m k).
//
// It has an account of its own, beside the closed loop's port: what it gave to the handle, less what of that
// is the handle's motion and comes back, less what the device's own damping has taken for certain,
//     E = G - g m v^2 / 2 - sum b |x_j - x_(j-1)|^2 / t,   v the filter's, over windows of t = 10 ms.
// The hand has then put in (1 - g) m v^2 / 2 - E or more: device and compensation are passive for as long as
// E stays in its budget. From half of it on g fades, within 20 ms; while it does, the handle is braked by
// |dg/dt| m v / 2, which takes back what was lent, and as long as more than half was given, by more. It
// comes back once E is below a quarter of the budget. What damping took is remembered down to minus the
// budget, so that no calm minute pays for a wild second.
//
// The torque of arm is no spring's: it turns the hand as it comes and goes. Its account forgets over a
// second, and above 20 mJ it fades.

#include <cstddef>
#include <optional>
#include <vector>

#include "haptics/effects/inertia_compensation/inertia_record.h"
#include "haptics/estimate/acceleration.h"
#include "haptics/math/wrench.h"
#include "haptics/signal/ramp.h"
#include "haptics/tick/command.h"

namespace fulcrum {

struct InertiaCompensationDesc {
  InertiaMethod method = InertiaMethod::acceleration;  // at the start
  bool switchable = true;  // to the others, while running; without it only what `method` needs is built
  double gain = 1;         // g, 0 to 1, of acceleration; 0: named but off
  double budget = 1e-3;    // J
  AccelerationEstimatorDesc filter{};
  std::optional<double> encoder_noise{};  // m rms, of the position; without it that of the device's encoder
};

inline void mirror(InertiaCompensationDesc&) {}  // it has no sides

class InertiaCompensation {
public:
  struct Figures {
    double tick_s = 1e-3;
    double mass = 0;           // kg, m
    double damping = 0;        // N s/m, b
    double encoder_step = 0;   // m
    double largest_force = 0;  // N, of m a
  };
  InertiaCompensation(const InertiaCompensationDesc& desc, const Figures& figures);

  void apply(const Command& command) noexcept;

  struct Tick {
    Vec3 p_DH = Vec3::Zero();     // (3) m, as measured
    Vec3 force_D = Vec3::Zero();  // (3) N, what is rendered on the handle
    Vec3 p_HG_D = Vec3::Zero();   // (3) m, where the hand holds
    bool between = false;         // what is touched lies between hand and stage
    bool open = false;            // the hand holds the tool and feels all of it
  };
  // The wrench that it adds on the handle, in D about H.
  Wrench process(const Tick& tick) noexcept;
  // commanded: the share of that wrench that was rendered, 0 to 1. moved_D: (6) m and rad, displacement since
  // the sample before; held_D: (6) the part of it made while a single command was applied (the rest straddles
  // two). age: s, since that sample was taken.
  struct Shares {
    double force = 1, torque = 1;
  };
  void book(const Shares& commanded, const Vec6& moved_D, const Vec6& held_D, double age) noexcept;

  // Whether a scene's method, or one that it can be switched to, needs the acceleration.
  static bool filters(const InertiaCompensationDesc& desc);
  const AccelerationEstimator* filter() const { return filter_ ? &*filter_ : nullptr; }
  const InertiaRecord& record() const { return record_; }
  const InertiaCompensationDesc& desc() const { return desc_; }
  const Figures& figures() const { return figures_; }

private:
  void fade(bool open) noexcept;
  Vec3 force() const noexcept;
  void take_damping(const Vec3& moved_D) noexcept;

  InertiaCompensationDesc desc_;
  Figures figures_;
  std::optional<AccelerationEstimator> filter_;
  Ramp arm_;
  double falling_ = 0;  // 1/s, how fast g falls in this tick
  const Wrench& commanded(std::size_t ticks_ago) const noexcept;

  std::vector<Wrench> commanded_D_;  // (n) a ring over what a sample may be late
  std::size_t newest_ = 0;
  int catching_up_ = 0;  // ticks, that are still to come at once
  bool faded_ = false, arm_faded_ = false;
  double given_ = 0;           // J, G less the damping's part
  Vec3 way_D_ = Vec3::Zero();  // (3) m, in the window of damping that is open
  int ticks_ = 0;              // of that window
  InertiaRecord record_;
};

}  // namespace fulcrum
