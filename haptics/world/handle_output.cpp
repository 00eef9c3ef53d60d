#include "haptics/world/handle_output.h"

#include <algorithm>

#include "haptics/world/handle_input.h"

namespace fulcrum {
namespace {

// What was commanded of a force, 0 to 1.
double part_of(const Vec3& commanded, const Vec3& wanted) {
  if (commanded == wanted) return 1;
  const double size = wanted.squaredNorm();
  return size > 0 ? std::clamp(commanded.dot(wanted) / size, 0.0, 1.0) : 0.0;
}

// Of the energy in springs whose force the device clamps, what can come back through it, 0 to 1. Of a spring
// that is pressed to 1 / p times what comes through, the way back gives p of the force until the rest is let
// go of, and then the rest: (2 p - p^2) of k d^2 / 2. Where force and torque are clamped it may come back by
// the one that is clamped less.
double returnable(const Wrench& wanted_F_H_D, double force_part, double torque_part) {
  if (wanted_F_H_D.is_zero()) return 1;
  const double force = wanted_F_H_D.force.isZero(0) ? 0 : force_part;
  const double torque = wanted_F_H_D.torque.isZero(0) ? 0 : torque_part;
  const double p = std::max(force, torque);
  return p * (2 - p);
}

Wrench handle_weight(const SceneDesc& desc) {
  Wrench weight;
  // D's y is up, however the device's base lies in the scene.
  if (desc.device.renders_force) weight.force = Vec3(0, desc.device.handle_weight, 0);
  return weight;
}

// How much of a vector another one is, 0 to 1.
double share(const Vec3& of, const Vec3& whole) {
  const double size = whole.norm();
  return size > 0 ? std::min(1.0, of.norm() / size) : 0.0;
}

}  // namespace

HandleOutput::HandleOutput(const SceneDesc& desc)
    : mapping_(desc.mapping),
      renders_force_(desc.device.renders_force),
      renders_torque_(desc.device.renders_torque),
      grasped_(desc.holding_point.has_value()),
      tool_weight_(tool_weight(desc.tool)),
      handle_weight_F_H_D_(handle_weight(desc)),
      motors_(desc.device, desc.allocation),
      guard_(desc.device, desc.tick_s, transient_sources(desc, desc)),
      output_limit_(desc.device, desc.tick_s),
      observer_(encoder_steps(desc.device), desc.device.renders_force, desc.device.renders_torque),
      passivity_(desc.device, desc.tick_s) {}

std::uint32_t HandleOutput::watch(const DeviceSample& sample, std::span<const Command> commands) noexcept {
  return guard_.watch(sample, commands);
}

void HandleOutput::stop(std::uint32_t& faults) noexcept {
  if ((faults & kStoppingFaults) != 0) guard_.stop(faults & kStoppingFaults);
  faults |= guard_.reason();
}

Wrench HandleOutput::in_device(const Wrench& F_H_W) noexcept {
  unlimited_F_H_D_ = mapping_.wrench_in_device(F_H_W);
  Wrench F_H_D = unlimited_F_H_D_;
  if (!renders_force_) F_H_D.force.setZero();
  if (!renders_torque_) F_H_D.torque.setZero();
  return F_H_D;
}

const Wrench& HandleOutput::resist(const Vec6& per_tick_D, std::uint32_t& faults) noexcept {
  resistance_F_H_D_ = passivity_.resist(observer_.deficit(), per_tick_D);
  if (!resistance_F_H_D_.is_zero()) faults |= kPassivityControl;
  return resistance_F_H_D_;
}

Vec3 HandleOutput::render(const Wrench& wanted_F_H_D, const Wrench& correction_F_H_D,
                          const HandleMotion& handle, std::uint32_t& faults) noexcept {
  all_F_H_D_ = wanted_F_H_D + handle_weight_F_H_D_;
  if (!correction_F_H_D.is_zero()) all_F_H_D_ += correction_F_H_D;  // for -0 + 0 is 0
  const Wrench limited_F_H_D = guard_.limit(all_F_H_D_, faults);
  motors_.begin(handle.X_DH);
  continuous_ = allocate_continuous(limited_F_H_D, handle.p_HG_D, faults);
  motors_.reserve(continuous_);
  command_F_H_D_ = continuous_.F_H_D;
  // Slew goes on from what the motors did: what they have not is missing of what was wanted before it.
  shortfall_F_H_D_ =
      (continuous_.clamped() ? all_F_H_D_ * guard_.gain() : limited_F_H_D) + -continuous_.F_H_D;
  transients_ = {};
  rendered_ = {};
  return limited_F_H_D.force - handle_weight_F_H_D_.force * guard_.gain();
}

// What is cut changes no faster than the slew limit either. It begins at what the motors can hold here of the
// last tick's: where that is less, because the handle has come to where they are weaker, the force falls at
// once.
Allocation HandleOutput::allocate_continuous(const Wrench& limited_F_H_D, const Vec3& p_HG_D,
                                             std::uint32_t& faults) noexcept {
  Allocation wanted = motors_.wrench(limited_F_H_D);
  if (wanted.clamped() && grasped_)  // what is cut keeps its direction where the hand feels it
    wanted = motors_.wrench(limited_F_H_D, p_HG_D);
  if (wanted.F_H_D.force == limited_F_H_D.force && wanted.F_H_D.torque == limited_F_H_D.torque) return wanted;
  faults |= kMotorClamped;
  const Allocation held = motors_.allocate_uniform(guard_.last());
  const double part = guard_.slew_part(held.F_H_D, wanted.F_H_D);
  if (part == 1) return wanted;
  faults |= kSlewLimited;
  return motors_.between(held, wanted, part);
}

void HandleOutput::want(const Transient& transient) noexcept {
  Transient& wanted = transients_[static_cast<std::size_t>(transient.source)];
  wanted = transient;
  if (wanted.F_H_D.is_zero()) wanted.grasp.reset();
}

// Asks for far more than there is. What the motors can do of it is found first, and then bounded.
Allocation HandleOutput::allocate_grasped(const Transient& wanted, const Vec6& moved_D,
                                          std::uint32_t& faults) noexcept {
  const Grasp& grasp = *wanted.grasp;
  Allocation able = grasp.moment ? motors_.pulse(wanted.F_H_D, grasp.p_HG_D, grasp.lever)
                                 : motors_.allocate_uniform(wanted.F_H_D);
  const Wrench allowed = guard_.limit_transient(wanted.source, able.F_H_D, command_F_H_D_, moved_D, faults);
  if (allowed.force == able.F_H_D.force && allowed.torque == able.F_H_D.torque) return able;
  const auto felt = [&grasp](const Wrench& F_H_D) {
    return Vec3(grasp.p_HG_D.cross(F_H_D.force) - F_H_D.torque);
  };
  Allocation allocation = motors_.allocate_uniform(allowed);
  allocation.force_share = share(allocation.F_H_D.force, wanted.F_H_D.force);
  allocation.moment_share = share(felt(allocation.F_H_D), felt(wanted.F_H_D));
  return allocation;
}

Allocation HandleOutput::allocate_transient(const Transient& wanted, const Vec6& moved_D,
                                            std::uint32_t& faults) noexcept {
  if (wanted.grasp) return allocate_grasped(wanted, moved_D, faults);
  const Wrench allowed = guard_.limit_transient(wanted.source, wanted.F_H_D, command_F_H_D_, moved_D, faults);
  if (allowed.is_zero()) return {.F_H_D = allowed};
  return motors_.allocate_uniform(allowed);
}

void HandleOutput::render_transients(const Vec6& moved_D, std::uint32_t& faults) noexcept {
  for (std::size_t i = 0; i < kTransientSources; ++i) {
    Transient& wanted = transients_[i];
    wanted.source = TransientSource{i};
    const TransientBudget* budget = guard_.budget(wanted.source);
    if (budget == nullptr) {  // no effect of the scene asks for this source: nothing of it is sent
      if (!wanted.F_H_D.is_zero()) {
        faults |= kTransientLimited;
        shortfall_F_H_D_ += wanted.F_H_D;
      }
      continue;
    }
    const Allocation allocation = allocate_transient(wanted, moved_D, faults);
    const Wrench& F_H_D = allocation.F_H_D;
    if (!F_H_D.is_zero() || wanted.grasp) motors_.reserve(allocation);
    if (allocation.clamped()) faults |= kMotorClamped;
    guard_.commanded(wanted.source, F_H_D);
    shortfall_F_H_D_.force += wanted.F_H_D.force - F_H_D.force;
    shortfall_F_H_D_.torque += wanted.F_H_D.torque - F_H_D.torque;
    if (!F_H_D.force.isZero(0)) command_F_H_D_.force += F_H_D.force;  // for -0 + 0 is 0
    if (!F_H_D.torque.isZero(0)) command_F_H_D_.torque += F_H_D.torque;
    rendered_.sources[i] = {F_H_D,
                            allocation.force_share,
                            allocation.moment_share,
                            budget->energy(),
                            budget->force_energy(),
                            budget->torque_energy()};
  }
  limit_output(faults);
  rendered_.force_part = part_of(continuous_.F_H_D.force, all_F_H_D_.force);
  rendered_.torque_part = part_of(continuous_.F_H_D.torque, all_F_H_D_.torque);
}

void HandleOutput::limit_output(std::uint32_t& faults) noexcept {
  effort_ = motors_.taken();
  OutputLimit::Output output{
      .continuous = {continuous_.F_H_D, continuous_.effort},
      .transient = {command_F_H_D_ + -continuous_.F_H_D, effort_ - continuous_.effort}};
  const std::uint32_t beyond = output_limit_.hold(output);
  if (beyond != 0) {
    command_F_H_D_ = output.continuous.F_H_D + output.transient.F_H_D;
    effort_ = output.continuous.effort + output.transient.effort;
    continuous_.F_H_D = output.continuous.F_H_D;
    faults |= beyond;
  }
  guard_.commanded(continuous_.F_H_D);  // before a stop, which falls from what was sent
  if ((beyond & kStoppingFaults) != 0) guard_.stop(beyond & kStoppingFaults);
}

void HandleOutput::book(const Vec6& moved_D, const Wrench& correction_F_H_D, const Stores& stores,
                        std::uint32_t& faults) noexcept {
  Wrench felt_F_H_D = continuous_.F_H_D + handle_weight_F_H_D_ * -guard_.gain();
  if (!correction_F_H_D.force.isZero(0)) felt_F_H_D.force -= correction_F_H_D.force;
  if (!correction_F_H_D.torque.isZero(0)) felt_F_H_D.torque -= correction_F_H_D.torque;
  if (!renders_force_) felt_F_H_D.force = unlimited_F_H_D_.force * guard_.gain();
  if (!renders_torque_) felt_F_H_D.torque = unlimited_F_H_D_.torque * guard_.gain();
  const double energy_scale = mapping_.energy_scale();
  double springs = energy_scale * stores.springs;
  if (stores.effects != 0) springs += stores.effects;
  // A force that only lags behind what is wanted is no clamp.
  if ((faults & kSlewLimited) == 0)
    springs *= returnable(all_F_H_D_, rendered_.force_part, rendered_.torque_part);
  observer_.update(moved_D, {.F_H_D = felt_F_H_D,
                             .weight = energy_scale * tool_weight_ * stores.height,
                             .springs = springs,
                             .open = guard_.gain() >= 1.0});
  if (observer_.port() < kPortBound) faults |= kEnergyBound;
}

void HandleOutput::leave(DeviceCommand& command, TickRecord& record) const noexcept {
  command.F_H_D = command_F_H_D_;
  command.cues.paused = is_pause(guard_.reason());
  for (int motor = 0; motor < motors_.motors(); ++motor) {
    const auto slot = static_cast<std::size_t>(motor);
    command.effort[slot] = effort_[motor];
    record.actuator_load[slot] = motors_.load(motor, effort_[motor]);
  }
  record.device_F_H_D = command_F_H_D_;
  record.shortfall_F_H_D = shortfall_F_H_D_;
  record.energy_port = observer_.port();
  record.energy_unrendered = observer_.unrendered();
  record.force_gain = guard_.gain();
  record.stopped = guard_.stopped();
}

}  // namespace fulcrum
