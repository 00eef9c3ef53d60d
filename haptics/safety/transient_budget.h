#pragma once
// What transients may do: forces that no slew limit slows down, because they are there to be sudden. Whatever
// asks for them, over any 100 ms they are bounded in
//     peak        kPeak of the device's largest force, the part that a coupling that suits the device leaves
//                 free (coupling_gains.h)
//     impulse     |sum F dt| at most the peak for 5 ms: none pushes to one side for longer
//     length      sum |F| dt at most the peak for 70 ms: a tone at the peak has 64
//     energy      5 mJ given to the hand, what a handle of 70 g has at 0.38 m/s
// A force beyond the first is shortened. One that would go beyond another is left out, in this tick and until
// there is room for it.

#include <cstddef>
#include <vector>

#include "haptics/device/device.h"

namespace fulcrum {

class TransientBudget {
public:
  static constexpr double kWindow = 0.1;    // s
  static constexpr double kPeak = 0.1;      // of the device's largest force
  static constexpr double kPush = 5e-3;     // s, at the peak, to one side
  static constexpr double kLength = 70e-3;  // s, at the peak, to any
  static constexpr double kEnergy = 5e-3;   // J

  TransientBudget(const DeviceDesc& device, double tick_s);

  // One tick: `wanted` (3) N, as much of it as may be. moved (3) m: the handle's way since the last call,
  // under the force that it answered. Both in one frame.
  Vec3 allow(const Vec3& wanted, const Vec3& moved) noexcept;
  // What was commanded of it in the end (3) N.
  void commanded(const Vec3& force) noexcept;

  double energy() const { return energy_; }  // J, given to the hand since the start
  double peak() const { return peak_; }      // N
  std::size_t bytes() const { return spent_.capacity() * sizeof(Spent); }

private:
  struct Spent {
    Vec3 impulse = Vec3::Zero();  // (3) N s
    double length = 0;            // N s
    double energy = 0;            // J
  };

  double tick_s_, peak_;
  std::vector<Spent> spent_;  // of the last kWindow, one a tick
  std::size_t at_ = 0;        // the oldest of them
  std::size_t quiet_ = 0;  // ticks since the last transient: from the window's length on it holds zeros alone
  Vec3 last_ = Vec3::Zero();
  double energy_ = 0;
};

}  // namespace fulcrum
