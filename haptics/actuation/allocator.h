#pragma once
// Wanted wrenches on the handle -> motor efforts within their limits, in every tick, for every device.
//
// What goes beyond the motors is cut down by one of three methods:
//     exact          Force and moment each keep their direction. gamma is the share of the force that is
//                    rendered, mu that of the moment; they are chosen to make the shortfall of both least,
//                    the moment counted in units of its lever (share_program.h). Motors with range to spare
//                    help.
//     algorithm1     "Hybrid Force-Moment Braking Pulse", Algorithm 1, with the sign of line 9 turned round
//                    (m_r = r x f - m is its own Eq. 5) and SCALE comparing with its own s: pseudoinverse,
//                    force first, then as much of the moment as the motors still have.
//     pseudoinverse  All efforts scaled alike.
// Only a pulse has a force and a moment that stand in for each other: for other wrenches algorithm1 is the
// pseudoinverse.
//
// Beside the motors' limits each of them keeps the device's largest force, and its largest torque about the
// handle: all wrenches of a tick together.

#include "haptics/actuation/share_program.h"
#include "haptics/math/names_of.h"

namespace fulcrum {

enum class AllocationMethod { exact, algorithm1, pseudoinverse };
template <>
inline constexpr std::array<std::string_view, 3> names_of<AllocationMethod>{"exact", "algorithm1",
                                                                            "pseudoinverse"};

struct AllocationDesc {
  AllocationMethod method = AllocationMethod::exact;
  double moment_weight = 1;  // what missing moment counts beside missing force, by `exact`
};

struct Allocation {
  Effort effort = Effort::Zero();
  Wrench F_H_D;             // what it adds up to on the handle
  double force_share = 1;   // gamma, of what was wanted
  double moment_share = 1;  // mu, of the moment, or for a pulse of the moment that the hand was to feel
  bool clamped() const { return force_share < 1 || moment_share < 1; }
};

class Allocator {
public:
  explicit Allocator(const DeviceDesc& device, const AllocationDesc& desc = {});

  // A tick: the handle is at X_DH, and no motor does anything yet.
  void begin(const Pose& X_DH) noexcept;
  // Reserves the efforts of an allocation: later calls in this tick get what is left of each motor's range.
  void reserve(const Allocation& allocation) noexcept {
    taken_ += allocation.effort;
    taken_F_H_D_ += allocation.F_H_D;
  }

  // Force and torque each in their direction, as much as there can be: the torque about the control point,
  // p_HG_D (3) m from the handle, where the hand feels it.
  Allocation wrench(const Wrench& F_H_D, const Vec3& p_HG_D = Vec3::Zero()) const noexcept;
  // Force and torque scaled by the same factor, at most 1: the wrench keeps its axis.
  Allocation allocate_uniform(const Wrench& F_H_D) const noexcept;
  // A pulse that a hand which holds the handle at G, p_HG_D (3) m away, would feel as a moment
  // m_r = p_HG x f - m too. Where the motors have not force enough, a moment makes up for it: m_r in its
  // direction, and never more than the whole pulse would make it. lever m: what counts it beside force.
  Allocation pulse(const Wrench& F_H_D, const Vec3& p_HG_D, double lever) const noexcept;

  // Part of the way from one allocation of this pose to another, 0 to 1: within every limit, as both of them
  // are.
  static Allocation between(const Allocation& from, const Allocation& to, double part) noexcept;

  int motors() const { return actuators_.count(); }
  const Effort& taken() const { return taken_; }         // so far in this tick, within the limits
  double load(int motor, double effort) const noexcept;  // fraction of the limit, signed, -1 to 1
  const Actuators& actuators() const { return actuators_; }

private:
  Allocation scaled(const Wrench& F_H_D, bool use_spare) const noexcept;
  Allocation algorithm1(const Wrench& F_H_D, const Vec3& p_HG_D) const noexcept;
  Allocation shared(const Wrench& F_H_D, const Vec3& p_HG_D, double lever) const noexcept;
  double largest_share(const Effort& effort, const Effort& beside) const noexcept;
  double largest_share(const Wrench& F_H_D, const Wrench& beside_F_H_D) const noexcept;
  Allocation given(const Wrench& wanted, const Shares& shares) const noexcept;

  AllocationDesc desc_;
  Actuators actuators_;
  MotorSpace space_;
  double lever_;                   // m, of torque beside force, where nothing else says so
  double max_force_, max_torque_;  // N, N m; of the device
  Effort taken_;
  Wrench taken_F_H_D_;
};

}  // namespace fulcrum
