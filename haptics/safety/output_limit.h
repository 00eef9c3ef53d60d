#pragma once
// The last thing that a tick does to its command. Whatever came before it, what leaves the tick keeps the
// device's largest force and torque and each motor's limit, and its continuous part changes no faster than
// the slew limit. Guard, budgets and allocation see to all of that; here it is asked of the numbers that are
// sent, and what is beyond a limit is made smaller in its direction, so that efforts and wrench go on to
// belong together.
//
// The continuous wrench may fall towards nothing as fast as it must: motors that are weaker where the handle
// has come to cannot hold what they held, and a stop has to be quick. It never grows, or turns aside, faster
// than the limit; where it falls and turns aside in one tick, the whole change may be more than a step.

#include "haptics/actuation/actuators.h"
#include "haptics/math/wrench.h"
#include "haptics/safety/faults.h"

namespace fulcrum {

inline constexpr double kSlewTime = 5e-3;  // s, from nothing to the device's limit at the fastest

// N and N m: how far the continuous force and torque may change in a tick.
struct SlewSteps {
  SlewSteps(const DeviceDesc& device, double tick_s)
      : force(device.max_force / kSlewTime * tick_s), torque(device.max_torque / kSlewTime * tick_s) {}
  double force, torque;

  // The largest part of the way between two wrenches, 0 to 1, that may be gone in a tick.
  double part(const Wrench& from, const Wrench& to) const noexcept;
};

class OutputLimit {
public:
  OutputLimit(const DeviceDesc& device, double tick_s);

  struct Part {
    Wrench F_H_D;  // on the handle about H, in D
    Effort effort = Effort::Zero();
  };
  struct Output {
    Part continuous, transient;
  };
  // Answers kOutputLimited where something was beyond a limit and has been cut, with kNotFinite where it was
  // no number and has become nothing.
  std::uint32_t hold(Output& output) noexcept;

private:
  double largest_part(const Part& continuous) const noexcept;
  double largest_part(const Part& continuous, const Part& transient) const noexcept;
  bool within_slew(const Wrench& F_H_D) const noexcept;

  double max_force_, max_torque_;  // N, N m; 0: the device has no such axes
  SlewSteps steps_;
  Effort limits_;
  Wrench last_;  // continuous, as it was let out
};

}  // namespace fulcrum
