#include "haptics/safety/guard.h"

#include <algorithm>
#include <cmath>

#include "haptics/math/clamp_norm.h"

namespace fulcrum {
namespace {

Vec3 beside(const Vec3& there, const Vec3& transient, double limit) {
  return part_beside(there, transient, limit) * transient;
}

// The fault of a command that stops; 0 of one that does not.
std::uint32_t stop_by(Command::Kind kind) {
  switch (kind) {
    case Command::Kind::stop:
      return kStopRequested;
    case Command::Kind::watchdog:
      return kWatchdog;
    case Command::Kind::unanswered:
      return kUnanswered;
    default:
      return 0;
  }
}

}  // namespace

Guard::Guard(const DeviceDesc& device, double tick_s, std::span<const TransientSource> transients)
    : device_(device), tick_s_(tick_s), steps_(device, tick_s) {
  for (const TransientSource source : transients)
    budgets_[static_cast<std::size_t>(source)].emplace(figures_of(source), device, tick_s);
}

std::uint32_t Guard::watch(const DeviceSample& sample, std::span<const Command> commands) noexcept {
  std::uint32_t faults = 0;
  const bool usable = sample.X_DH.is_finite() && sample.X_DH.p.cwiseAbs().maxCoeff() <= kFarthestHandle &&
                      sample.X_DH.q.norm() > 0.5 && sample.age >= 0;
  if (!usable) faults |= kNotFinite;
  const bool has_motors = device_.renders_force || device_.renders_torque;
  if (sample.age > (has_motors ? kStaleSample : kStaleWithoutMotors)) faults |= kSampleStale;
  if (!sample.connected) faults |= kDeviceLost;
  bool acknowledged = acknowledged_;
  for (const Command& command : commands) {
    const std::uint32_t stops = stop_by(command.kind);
    faults |= stops;
    if (stops != 0) acknowledged = false;
    if (command.kind == Command::Kind::acknowledge) {
      acknowledged = true;
      releases_ = false;
    }
    if (command.kind == Command::Kind::release) releases_ = !stopped_;
  }
  if (releases_ && gain_ <= 0 && last_.is_zero()) faults |= kStopRequested;
  acknowledged_ = acknowledged && stopped_ && faults == 0;
  if (faults != 0) stop(faults);
  if (acknowledged_ && fall_ <= 0) {
    stopped_ = acknowledged_ = false;
    gain_ = 0;
  }
  return faults;
}

void Guard::stop(std::uint32_t reason) noexcept {
  if (stopped_) return;
  stopped_ = true;
  releases_ = false;
  reason_ = reason;
  fall_ = 1.0;
  falling_ = last_;
  falling_transients_ = last_transients_;
}

Wrench Guard::limit(const Wrench& wanted_F_H_D, std::uint32_t& faults) noexcept {
  if (stopped_) {
    fall_ = std::max(0.0, fall_ - tick_s_ / kStopFall);
    return falling_ * fall_;
  }
  const double step = tick_s_ / kRampIn;
  gain_ = releases_ ? std::max(0.0, gain_ - step) : std::min(1.0, gain_ + step);
  const Wrench ramped = wanted_F_H_D * gain_;

  Wrench F;
  F.force = clamp_norm(ramped.force, device_.renders_force ? device_.max_force : 0.0);
  F.torque = clamp_norm(ramped.torque, device_.renders_torque ? device_.max_torque : 0.0);
  // An axis that the device has not is left out, which is no event; a limit that it has and that acts is one.
  if (device_.renders_force && F.force != ramped.force) faults |= kForceClamped;
  if (device_.renders_torque && F.torque != ramped.torque) faults |= kTorqueClamped;

  const Vec3 force_step = clamp_norm(F.force - last_.force, steps_.force);
  const Vec3 torque_step = clamp_norm(F.torque - last_.torque, steps_.torque);
  Wrench slewed{last_.force + force_step, last_.torque + torque_step};
  constexpr double rounding = 1e-12;
  if ((slewed.force - F.force).norm() > rounding || (slewed.torque - F.torque).norm() > rounding) {
    faults |= kSlewLimited;
    return slewed;
  }
  return F;
}

Wrench Guard::limit_transient(TransientSource source, const Wrench& wanted_F_H_D, const Wrench& beside_F_H_D,
                              const Vec6& moved_D, std::uint32_t& faults) noexcept {
  std::optional<TransientBudget>& budget = budgets_[static_cast<std::size_t>(source)];
  if (!budget) return {};
  // What is stopped falls from what it was, whatever is wanted now.
  const Wrench wanted =
      stopped_ ? falling_transients_[static_cast<std::size_t>(source)] * fall_ : wanted_F_H_D * gain();
  if (!wanted.is_finite()) return {};
  const Wrench allowed = budget->allow(wanted, moved_D);
  if (allowed.force != wanted.force || allowed.torque != wanted.torque) faults |= kTransientLimited;
  return {beside(beside_F_H_D.force, allowed.force, device_.max_force),
          beside(beside_F_H_D.torque, allowed.torque, device_.max_torque)};
}

void Guard::commanded(const Wrench& continuous_F_H_D) noexcept {
  last_ = continuous_F_H_D;
}

void Guard::commanded(TransientSource source, const Wrench& transient_F_H_D) noexcept {
  std::optional<TransientBudget>& budget = budgets_[static_cast<std::size_t>(source)];
  if (!budget) return;
  budget->commanded(transient_F_H_D);
  last_transients_[static_cast<std::size_t>(source)] = transient_F_H_D;
}

}  // namespace fulcrum
