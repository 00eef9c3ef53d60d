#include "haptics/actuation/allocator.h"

#include <algorithm>

#include "haptics/math/clamp_norm.h"

namespace fulcrum {
namespace {

constexpr double kLever = 0.1;       // m, of a device that does not say what torque goes with its force
constexpr double kUnmade = 1e-6;     // of a force: what is missing of it when the motors cannot make it
constexpr double kLongLever = 1e-9;  // m: a shorter one is none

double lever_of(const DeviceDesc& device) {
  return device.max_force > 0 && device.max_torque > 0 ? device.max_torque / device.max_force : kLever;
}

}  // namespace

Allocator::Allocator(const DeviceDesc& device, const AllocationDesc& desc)
    : desc_(desc),
      actuators_(device),
      space_(actuators_),
      lever_(lever_of(device)),
      max_force_(device.max_force),
      max_torque_(device.max_torque),
      taken_(Effort::Zero()) {
  begin(Pose{});
}

void Allocator::begin(const Pose& X_DH) noexcept {
  if (motors() == 0) return;
  actuators_.follow(X_DH);
  space_.factorise(actuators_.wrenches(), lever_);
  taken_.setZero();
  taken_F_H_D_ = {};
}

double Allocator::load(int motor, double effort) const noexcept {
  const double limit = actuators_.limits()[motor];
  return limit > 0 ? std::clamp(effort / limit, -1.0, 1.0) : 0.0;
}

Allocation Allocator::between(const Allocation& from, const Allocation& to, double part) noexcept {
  const double rest = 1 - part;
  return {rest * from.effort + part * to.effort, from.F_H_D * rest + to.F_H_D * part,
          rest * from.force_share + part * to.force_share, rest * from.moment_share + part * to.moment_share};
}

Allocation Allocator::wrench(const Wrench& F_H_D, const Vec3& p_HG_D) const noexcept {
  if (motors() == 0) return {};
  if (desc_.method != AllocationMethod::exact) return scaled(F_H_D, false);
  return shared(F_H_D, p_HG_D, lever_);
}

Allocation Allocator::allocate_uniform(const Wrench& F_H_D) const noexcept {
  if (motors() == 0) return {};
  return scaled(F_H_D, desc_.method == AllocationMethod::exact);
}

Allocation Allocator::pulse(const Wrench& F_H_D, const Vec3& p_HG_D, double lever) const noexcept {
  if (motors() == 0) return {};
  switch (desc_.method) {
    case AllocationMethod::exact:
      return shared(F_H_D, p_HG_D, lever > kLongLever ? lever : lever_);
    case AllocationMethod::algorithm1:
      return algorithm1(F_H_D, p_HG_D);
    case AllocationMethod::pseudoinverse:
      return scaled(F_H_D, false);
  }
  return {};
}

Allocation Allocator::shared(const Wrench& F_H_D, const Vec3& p_HG_D, double lever) const noexcept {
  const Vec3& force = F_H_D.force;
  const Vec3 of_force = p_HG_D.cross(force), felt = of_force - F_H_D.torque;
  ShareProblem problem;
  problem.force_effort = space_.smallest({force, of_force});
  problem.moment_effort = space_.smallest({Vec3::Zero(), -felt});
  problem.spare = &space_.spare();
  problem.low = -actuators_.limits() - taken_;
  problem.high = actuators_.limits() - taken_;
  problem.force_size = force.norm();
  problem.moment_size = actuators_.rows() == 6 ? desc_.moment_weight * felt.norm() / lever : 0.0;
  const bool made = space_.complete() || (space_.wrench(problem.force_effort).force - force).norm() <=
                                             kUnmade * problem.force_size;
  if (!made) {
    problem.force_effort.setZero();
    problem.force_size = 0;
  }
  const Vec3 made_force = made ? force : Vec3(Vec3::Zero()),
             made_of_force = made ? of_force : Vec3(Vec3::Zero());
  problem.largest_force_share = part_beside(taken_F_H_D_.force, made_force, max_force_);
  bool fits = problem.largest_force_share == 1;
  if (actuators_.rows() == 6) {
    problem.torque = {taken_F_H_D_.torque, made_of_force, -felt,
                      std::max((1 - kRoundedLength) * max_torque_, taken_F_H_D_.torque.norm())};
    fits = fits && within_length(taken_F_H_D_.torque + made_of_force - felt, max_torque_);
  }
  const Effort all = problem.force_effort + problem.moment_effort;
  fits = fits && (all.array() <= problem.high.array()).all() && (all.array() >= problem.low.array()).all();
  Shares shares = fits ? Shares{1, 1, all} : solve_shares(problem);
  if (!made) shares.force = 0;
  return given(F_H_D, shares);
}

Allocation Allocator::scaled(const Wrench& F_H_D, bool use_spare) const noexcept {
  Shares shares;
  shares.effort = space_.smallest(F_H_D);
  const double by_device = largest_share(F_H_D, taken_F_H_D_);
  const double share = std::min(largest_share(shares.effort, taken_), by_device);
  if (share == 1) return given(F_H_D, shares);
  if (use_spare) {
    ShareProblem problem;
    problem.force_effort = shares.effort;
    problem.moment_effort = Effort::Zero();
    problem.spare = &space_.spare();
    problem.low = -actuators_.limits() - taken_;
    problem.high = actuators_.limits() - taken_;
    problem.largest_force_share = by_device;
    return given(F_H_D, solve_common_share(problem));
  }
  shares.effort *= share;
  shares.force = shares.moment = share;
  return given(F_H_D, shares);
}

Allocation Allocator::algorithm1(const Wrench& F_H_D, const Vec3& p_HG_D) const noexcept {
  const Effort force_effort = space_.smallest(F_H_D);
  const double gamma = std::min(largest_share(force_effort, taken_), largest_share(F_H_D, taken_F_H_D_));
  Shares shares{gamma, gamma, gamma * force_effort};
  if (gamma < 1) {
    const Vec3 felt = p_HG_D.cross(F_H_D.force) - F_H_D.torque;
    const Wrench moment{Vec3::Zero(), -(1 - gamma) * felt};
    const Effort moment_effort = space_.smallest(moment);
    const double delta = std::min(largest_share(moment_effort, taken_ + shares.effort),
                                  largest_share(moment, taken_F_H_D_ + F_H_D * gamma));
    shares.effort += delta * moment_effort;
    shares.moment = gamma + delta * (1 - gamma);
  }
  return given(F_H_D, shares);
}

// The largest part of `effort` that no motor is too weak for. SCALE of the paper.
double Allocator::largest_share(const Effort& effort, const Effort& beside) const noexcept {
  double share = 1;
  for (int motor = 0; motor < motors(); ++motor) {
    const double limit = actuators_.limits()[motor];
    const double room = effort[motor] > 0 ? limit - beside[motor] : limit + beside[motor];
    const double wanted = std::abs(effort[motor]);
    if (wanted > room) share = std::min(share, std::max(room, 0.0) / wanted);
  }
  return share;
}

// The largest part of a wrench that the device is not too weak for. Where motors set force alone its torque
// is none.
double Allocator::largest_share(const Wrench& F_H_D, const Wrench& beside_F_H_D) const noexcept {
  const double force = part_beside(beside_F_H_D.force, F_H_D.force, max_force_);
  if (actuators_.rows() == 3) return force;
  return std::min(force, part_beside(beside_F_H_D.torque, F_H_D.torque, max_torque_));
}

// Where all of it is there, what was wanted, to the bit.
Allocation Allocator::given(const Wrench& wanted, const Shares& shares) const noexcept {
  Allocation allocation{shares.effort, wanted, shares.force, shares.moment};
  if (allocation.clamped() || !space_.complete()) allocation.F_H_D = space_.wrench(shares.effort);
  if (!space_.complete()) {  // a torque that nobody wanted may have come with the force
    const double part = largest_share(allocation.F_H_D, taken_F_H_D_);
    allocation.effort *= part;
    allocation.F_H_D = allocation.F_H_D * part;
    allocation.force_share *= part;
    allocation.moment_share *= part;
  }
  if (actuators_.rows() == 3) {  // what moment there is comes of the force
    allocation.moment_share = allocation.force_share;
    if (!allocation.F_H_D.torque.isZero(0)) allocation.F_H_D.torque.setZero();
  }
  return allocation;
}

}  // namespace fulcrum
