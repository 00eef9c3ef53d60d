#include "haptics/effects/inertia_compensation/inertia_compensation.h"

#include <algorithm>
#include <cmath>

#include "haptics/math/clamp_norm.h"

namespace fulcrum {
namespace {

constexpr double kFades = 0.5;        // of the budget: the rest is for what fading takes
constexpr double kReturns = 0.25;     // of the budget, below which compensation returns
constexpr double kFall = 20e-3;       // s, from the whole gain to none
constexpr double kRise = 0.5;         // s, back
constexpr double kSwitch = 20e-3;     // s, of the arm's torque, in and out
constexpr double kOldest = 25e-3;     // s, of a sample: an older one stops the force
constexpr double kArmBudget = 20e-3;  // J, as much as a transient may give in a tenth of the time
constexpr double kArmForgets = 1;     // s
constexpr double kMaxCaughtUp = 100;  // ticks at once
constexpr double kRecovery = 2e-3;  // m, of the handle's travel, over which an excess of energy is taken back
constexpr double kBrake = 0.05;     // of what would stop the handle within a tick, at most
constexpr double kWindow = 10e-3;   // s, of damping: no stretch of it can have taken less than this says

}  // namespace

bool InertiaCompensation::filters(const InertiaCompensationDesc& desc) {
  return desc.switchable || desc.method == InertiaMethod::acceleration;
}

InertiaCompensation::InertiaCompensation(const InertiaCompensationDesc& desc, const Figures& figures)
    : desc_(desc), figures_(figures), arm_(kSwitch, figures.tick_s) {
  record_.method = desc.method;
  commanded_D_.resize(static_cast<std::size_t>(std::ceil(kOldest / figures.tick_s)) + 2);
  if (filters(desc)) filter_.emplace(desc.filter, figures.tick_s);
}

void InertiaCompensation::apply(const Command& command) noexcept {
  if (command.kind == Command::Kind::caught_up && command.value > 0)
    catching_up_ = static_cast<int>(std::min(command.value, kMaxCaughtUp));
  if (command.kind != Command::Kind::compensation || !desc_.switchable) return;
  const double method = std::round(command.value);
  if (method >= 0 && method <= 2) record_.method = static_cast<InertiaMethod>(static_cast<int>(method));
}

// What follows a stop or a clutch begins anew: by then the handle may be anywhere, at any speed.
void InertiaCompensation::fade(bool open) noexcept {
  falling_ = 0;
  if (!open) {
    record_.gain = given_ = record_.arm_energy = 0;
    faded_ = arm_faded_ = record_.faded = false;
    return;
  }
  if (record_.energy > kFades * desc_.budget) faded_ = true;
  if (faded_ && record_.gain == 0 && record_.energy < kReturns * desc_.budget) faded_ = false;
  if (record_.arm_energy > kArmBudget) arm_faded_ = true;
  if (arm_faded_ && record_.arm_energy < 0.5 * kArmBudget) arm_faded_ = false;
  record_.faded = faded_ || arm_faded_;
  const bool wanted = record_.method == InertiaMethod::acceleration && !faded_;
  const double target = wanted ? desc_.gain : 0.0;
  const double up = figures_.tick_s / kRise, down = figures_.tick_s / kFall;
  const double before = record_.gain;
  record_.gain += std::clamp(target - record_.gain, -down, up);
  falling_ = std::max(0.0, before - record_.gain) / figures_.tick_s;
}

// What brakes is bounded by safety alone: what was lent is to come back in full, and what was given beyond
// half of the budget over the next millimetres.
Vec3 InertiaCompensation::force() const noexcept {
  const Vec3 v = filter_->velocity();
  Vec3 f = figures_.mass * record_.gain * record_.acceleration_D;
  double brake = 0.5 * falling_ * figures_.mass;  // N s/m
  if (faded_ && !v.isZero(0)) {
    const double gives = f.dot(v);
    if (gives > 0) f -= gives / v.squaredNorm() * v;  // it takes, and gives no more
    const double excess = std::max(0.0, record_.energy - kFades * desc_.budget);
    brake += std::min(excess / kRecovery / v.norm(), kBrake * figures_.mass / figures_.tick_s);
  }
  return clamp_norm(f, figures_.largest_force) - brake * v;
}

Wrench InertiaCompensation::process(const Tick& tick) noexcept {
  Wrench F_H_D;
  fade(tick.open);
  if (filter_) {
    record_.acceleration_D = catching_up_ > 0 ? filter_->catch_up(tick.p_DH) : filter_->update(tick.p_DH);
    catching_up_ = std::max(0, catching_up_ - 1);
    F_H_D.force = force();
  }
  const bool arm = tick.open && tick.between && record_.method == InertiaMethod::arm && !arm_faded_;
  const double level = arm_.towards(arm ? 1.0 : 0.0);
  if (level > 0) F_H_D.torque = -level * tick.p_HG_D.cross(tick.force_D);
  record_.force_D = F_H_D.force;
  record_.torque_D = F_H_D.torque;
  return F_H_D;
}

const Wrench& InertiaCompensation::commanded(std::size_t ticks_ago) const noexcept {
  const std::size_t n = commanded_D_.size();
  return commanded_D_[(newest_ + n - std::min(ticks_ago, n - 1)) % n];
}

void InertiaCompensation::book(const Shares& shares, const Vec6& moved_D, const Vec6& held_D,
                               double age) noexcept {
  record_.force_D *= shares.force;
  record_.torque_D *= shares.torque;
  newest_ = (newest_ + 1) % commanded_D_.size();
  commanded_D_[newest_] = {record_.force_D, record_.torque_D};
  const double late = std::round((age > 0 ? std::min(age, kOldest) : 0.0) / figures_.tick_s);
  const Wrench& then = commanded(static_cast<std::size_t>(late) + 1);
  const Wrench& next = commanded(static_cast<std::size_t>(late));
  const Vec6 between_D = moved_D - held_D;
  given_ += then.force.dot(held_D.head<3>()) + 0.5 * (then.force + next.force).dot(between_D.head<3>());
  take_damping(moved_D.head<3>());
  const double speed_squared = filter_ ? filter_->velocity().squaredNorm() : 0.0;
  const double lent = 0.5 * record_.gain * figures_.mass * speed_squared;
  given_ = std::max(given_, lent - desc_.budget);
  record_.energy = given_ - lent;

  const double by_arm =
      then.torque.dot(held_D.tail<3>()) + 0.5 * (then.torque + next.torque).dot(between_D.tail<3>());
  const double kept = 1 - std::min(1.0, figures_.tick_s / kArmForgets);
  record_.arm_energy = std::max(kept * record_.arm_energy + by_arm, -kArmBudget);
}

// Of all motions between two places in a given time the even one loses least (Cauchy and Schwarz); the
// encoder may show up to a count too much of the way.
void InertiaCompensation::take_damping(const Vec3& moved_D) noexcept {
  way_D_ += moved_D;
  const double elapsed = ++ticks_ * figures_.tick_s;
  if (elapsed < kWindow) return;
  const Vec3 least = (way_D_.cwiseAbs().array() - figures_.encoder_step).max(0.0);
  given_ -= figures_.damping * least.squaredNorm() / elapsed;
  way_D_.setZero();
  ticks_ = 0;
}

}  // namespace fulcrum
