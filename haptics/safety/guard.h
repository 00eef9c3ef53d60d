#pragma once
// What may be asked of the motors: stop, ramp-in, clamp, slew limit and the budget of transients. Its figures
// come from the device alone. Nothing in a scene, an effect or a plug-in can change or pass it. Allocation
// follows, and after it output_limit.h has the last word.

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "haptics/device/device.h"
#include "haptics/math/wrench.h"
#include "haptics/safety/faults.h"
#include "haptics/safety/output_limit.h"
#include "haptics/safety/transient_budget.h"
#include "haptics/tick/command.h"

namespace fulcrum {

inline constexpr double kStopFall = 2e-3;  // s, from the commanded force to nothing
inline constexpr double kRampIn = 0.5;  // s, from nothing to the whole force; and back, where it is released
inline constexpr double kStaleSample = 20e-3;  // s, a sample older than this stops the force
// The same for a device without motors: no force answers its samples, so that an old one makes no energy. The
// tool goes on as it was last told for so long at most.
inline constexpr double kStaleWithoutMotors = 0.1;  // s
inline constexpr double kFarthestHandle =
    1e3;  // m, from D's origin: no handle is there, the sample is damaged

class Guard {
public:
  // transients: what in the scene asks for them.
  Guard(const DeviceDesc& device, double tick_s, std::span<const TransientSource> transients);

  // What the sample and the commands of this tick ask for. Returns the faults that are present now.
  std::uint32_t watch(const DeviceSample& sample, std::span<const Command> commands) noexcept;
  // Faults found later in the tick.
  void stop(std::uint32_t reason) noexcept;

  // The wrench on the handle that may be commanded, in D: the continuous wrench after ramp, clamp and slew,
  // or the fall to zero while stopped. Adds the bits of the limits that acted.
  Wrench limit(const Wrench& wanted_F_H_D, std::uint32_t& faults) noexcept;
  // After limit(): the transient wrench that may be added to what is there already, the continuous wrench and
  // the transients before it. It keeps out of their way: together they stay within the device's limits.
  // moved_D (6) m and rad: the handle's way in this tick. Nothing of a source that was not asked for.
  Wrench limit_transient(TransientSource source, const Wrench& wanted_F_H_D, const Wrench& beside_F_H_D,
                         const Vec6& moved_D, std::uint32_t& faults) noexcept;
  // The largest part of the way from one continuous wrench to another, 0 to 1, that may be gone in this tick.
  // A stop may go all of it.
  double slew_part(const Wrench& from_F_H_D, const Wrench& to_F_H_D) const noexcept {
    return stopped_ ? 1.0 : steps_.part(from_F_H_D, to_F_H_D);
  }
  // What was commanded in the end; slew and stop go on from the continuous wrench.
  void commanded(const Wrench& continuous_F_H_D) noexcept;
  void commanded(TransientSource source, const Wrench& transient_F_H_D) noexcept;

  const Wrench& last() const { return last_; }  // continuous, on the handle, in D; of the tick before
  bool stopped() const { return stopped_; }
  // The faults that stopped the force, until it is acknowledged.
  std::uint32_t reason() const { return stopped_ ? reason_ : 0; }
  // The part of the wanted wrench that was let through by ramp and stop at the last limit(), 0 to 1.
  double gain() const { return stopped_ ? gain_ * fall_ : gain_; }
  // Null: nothing asked for it.
  const TransientBudget* budget(TransientSource source) const {
    const std::optional<TransientBudget>& budget = budgets_[static_cast<std::size_t>(source)];
    return budget ? &*budget : nullptr;
  }

private:
  DeviceDesc device_;
  double tick_s_;
  SlewSteps steps_;
  bool stopped_ = false;
  bool releases_ = false;  // the force ramps out, to a stop that nobody feels
  // An acknowledgement waits until the force has fallen. Where the stop's cause is still there and is found
  // later in the tick, the fall would else begin anew with every acknowledgement.
  bool acknowledged_ = false;
  std::uint32_t reason_ = 0;
  double gain_ = 0;
  double fall_ = 0;  // part of the fall that is left, 1 to 0
  Wrench falling_;   // what was commanded when the stop came
  std::array<Wrench, kTransientSources> falling_transients_{}, last_transients_{};  // by source
  Wrench last_;
  std::array<std::optional<TransientBudget>, kTransientSources> budgets_;
};

}  // namespace fulcrum
