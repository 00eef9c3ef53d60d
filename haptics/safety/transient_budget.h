#pragma once
// What transients may do: wrenches that no slew limit slows down, because they are there to be sudden. Each
// source has a budget of its own, with figures that suit it, and an account of the energy that it gives to
// the hand. Over any 100 ms force and torque are bounded in
//     peak        a part of the device's largest force, and of its largest torque
//     impulse     |sum F dt| at most the peak for `push`: none pushes to one side for longer
//     length      sum |F| dt at most the peak for `length`
//     energy      given to the hand, by force and by torque each: energy absorbed by one does not enlarge the
//     other
// A force or torque beyond the first is clamped. A wrench that would go beyond another is left out, in
// this tick and until there is room for it.

#include <array>
#include <cstddef>
#include <vector>

#include "haptics/device/device.h"
#include "haptics/math/wrench.h"
#include "haptics/tick/transient.h"

namespace fulcrum {

struct TransientFigures {
  const char* name;  // of the budget, as `fulcrum explain` calls it
  double peak;       // of the device's largest force and torque
  double push;       // s, at the peak, to one side
  double length;     // s, at the peak, to any
  double energy;     // J
};

inline constexpr auto kTransientFigures = std::to_array<TransientFigures>({
    // A pulse that stops a hand wants all that the motors have, for as long as it takes: 10 ms of a device's
    // largest force stop a hand of 0.45 kg at 0.15 m/s with 6.7 N. It goes against the hand's way and takes
    // energy; the bound is for what a moment, or a hand that has been stopped and is pushed on, gets.
    {.name = "pulse budget", .peak = 1, .push = 10e-3, .length = 20e-3, .energy = 20e-3},
    // A tone of 80 Hz or more, for as long as torque is bad. The peak is the part that a coupling which suits
    // the device leaves free (coupling_gains.h). A half wave at the peak pushes for 4 ms; a tone at it has a
    // length of 64 ms. The energy is what a handle of 70 g has at 0.38 m/s.
    {.name = "transient budget", .peak = 0.1, .push = 5e-3, .length = 70e-3, .energy = 5e-3},
    // Tones of 12 to 40 Hz that die away within a second, several at once. Twice the peak, which a blow
    // mostly finds free: the coupling has only begun to press. At 12 Hz a half wave lasts 42 ms, and no sum
    // of such tones pushes to one side for longer. The energy is what a hand of 0.4 kg has at 0.32 m/s, less
    // than it brings to a hard blow. A voice at its strongest (impact_vibration.h) gives 0.4 mJ to a hand of
    // 400 N/m and 4 N s/m that resonates with it; 12 Hz at the peak would give 31 mJ: the bound is for that.
    {.name = "impact budget", .peak = 0.2, .push = 42e-3, .length = 70e-3, .energy = 20e-3},
});
static_assert(kTransientFigures.size() == kTransientSources);

constexpr const TransientFigures& figures_of(TransientSource source) {
  return kTransientFigures[static_cast<std::size_t>(source)];
}

class TransientBudget {
public:
  static constexpr double kWindow = 0.1;  // s

  TransientBudget(const TransientFigures& figures, const DeviceDesc& device, double tick_s);

  // One tick: `wanted`, as much of it as may be. moved (6) m and rad: the handle's way since the last call,
  // under the wrench that it answered. Both in one frame.
  Wrench allow(const Wrench& wanted, const Vec6& moved) noexcept;
  // What was commanded of it in the end.
  void commanded(const Wrench& F) noexcept;

  const TransientFigures& figures() const { return figures_; }
  // J, given to the hand since the start: by the force, by the torque, by both.
  double force_energy() const { return force_energy_; }
  double torque_energy() const { return torque_energy_; }
  double energy() const { return force_energy_ + torque_energy_; }
  double peak() const { return peak_; }                // N
  double peak_torque() const { return peak_torque_; }  // N m
  std::size_t bytes() const { return (spent_.capacity() + blocks_.capacity()) * sizeof(Spent); }

private:
  struct Spent {
    Wrench impulse;                      // N s, N m s
    double length = 0;                   // N s
    double turn_length = 0;              // N m s
    double by_force = 0, by_torque = 0;  // J

    Spent& operator+=(const Spent& other) noexcept;
  };
  Spent window() noexcept;  // all that was spent in it

  TransientFigures figures_;
  double tick_s_, peak_, peak_torque_;
  std::vector<Spent> spent_;   // of the last kWindow, one a tick
  std::vector<Spent> blocks_;  // sums of `block_` neighbours of it each
  std::size_t block_;
  std::size_t at_ = 0;     // the oldest of them
  std::size_t quiet_ = 0;  // ticks since the last transient: from the window's length on it holds zeros alone
  Wrench last_;
  double force_energy_ = 0, torque_energy_ = 0;
};

}  // namespace fulcrum
