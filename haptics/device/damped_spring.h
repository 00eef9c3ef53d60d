#pragma once
// A spring between a device's handle and something that stands still, with a damper of its own: what an
// effect pushes with that has no virtual coupling. With s (m) how far it is pressed, dhat where to, and v the
// handle's velocity:
//     f = -clamp(K s + B v . dhat, 0, f_max) dhat
// K s, no larger than f_max, is the slope of a potential in s; the damper only takes, and the spring never
// pulls. All of it is at the device, in its own m and N, whatever the mapping is.
//
// B = 2 zeta sqrt(K m) of the bare handle m. The velocity is that of the encoders through a first-order
// low-pass, as the loop's WallLoop::filter_pole has it. A jump of the handle, by a device's error or over
// samples that were lost, is no velocity (estimate/encoder_motion.h): the spring alone answers it, and no
// faster than the slew limit.

#include "haptics/device/device.h"

namespace fulcrum {

class DampedSpring {
public:
  static constexpr double kMostShare = 0.5;     // of limit(): a coupling takes as much of its own
  static constexpr double kDampingRatio = 0.5;  // zeta
  static constexpr double kSmoothing = 2e-3;    // s, time constant of the low-pass

  // N/m, the stiffest that this device, let go, holds at this tick: the exact loop of device/linear_loop.h.
  static double limit(const DeviceDesc& device, double tick_s);
  // N/m, where none is given: a quarter of that limit, 2 f_c / D, which friction f_c holds still from one
  // encoder count D to the next (Diolaiti et al., IEEE Trans. Robotics 22(2), 2006), where there are both,
  // and `largest`, whichever is least.
  static double suited(const DeviceDesc& device, double tick_s, double largest);

  // stiffness: N/m; max_force: N.
  DampedSpring(double stiffness, double max_force, const DeviceDesc& device, double tick_s);

  // per_tick_D (3) m per tick, the handle's motion, in every tick.
  void move(const Vec3& per_tick_D) noexcept {
    velocity_D_ = pole_ * velocity_D_ + (1 - pole_) / tick_s_ * per_tick_D;
  }
  // N, how hard it pushes against a handle that presses it by s (m) along dhat_D (3), unit.
  double push(double s, const Vec3& dhat_D) const noexcept;
  // J, that it holds while it is pressed by s (m).
  double stored(double s) const noexcept;

  double stiffness() const { return stiffness_; }  // N/m
  double damping() const { return damping_; }      // N s/m
  double max_force() const { return max_force_; }  // N

private:
  double stiffness_, max_force_, damping_;
  double pole_;  // of the low-pass, 0 to 1
  double tick_s_;
  Vec3 velocity_D_ = Vec3::Zero();  // (3) m/s, through the low-pass
};

}  // namespace fulcrum
