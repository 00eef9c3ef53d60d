#include "haptics/device/simulated_device.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "haptics/math/clamp_norm.h"
#include "haptics/math/rotation.h"

namespace fulcrum {
namespace {

Vec3 stepped(const Vec3& x, double step) {
  return step > 0 ? Vec3((x / step).array().round() * step) : x;
}

bool alike(const Vec3& v) {
  return v.isConstant(v.x(), 0);
}

}  // namespace

SimulatedDevice::SimulatedDevice(const SimulatedDeviceDesc& desc, const Pose& X_DH)
    : desc_(desc),
      turns_alike_(alike(desc.device.handle_inertia) && alike(desc.device.angular_damping)),
      X_DH_(X_DH) {
  const DeviceDesc& d = desc_.device;
  for (std::size_t axis = 0; axis < 6; ++axis) {
    FrictionAxis& a = axes_[axis];
    const auto about = static_cast<Eigen::Index>(axis) - 3;
    a.mass = axis < 3 ? d.handle_mass : d.handle_inertia[about];
    a.damping = axis < 3 ? d.damping : d.angular_damping[about];
    a.friction = axis < 3 ? d.friction : d.angular_friction;
    a.x = axis < 3 ? X_DH_.p[static_cast<Eigen::Index>(axis)] : 0.0;
  }
  measured_ = {X_DH_.q, stepped(X_DH_.p, d.encoder_step)};
  seen_.fill({measured_});
}

SimulatedDevice::SimulatedDevice(const SimulatedDeviceDesc& desc, HandTask task)
    : SimulatedDevice(desc, task.mapping.handle_in_device(task.path.at(0) * task.X_HT.inverse())) {
  task_ = std::move(task);
  tremor_.emplace(task_->hand);
  if (task_->path.slides())
    hold_elsewhere();
  else
    for (std::size_t axis = 0; axis < 3; ++axis) axes_[axis].mass += task_->hand.mass;
  if (desc_.device.strip) {
    strip_.emplace(*desc_.device.strip, desc_.tick_s, task_->hand.seed);
    seen_.fill({measured_, kStripOpen});
  }
  if (task_->hand.yields) yielding_.emplace(*task_->hand.yields, desc_.tick_s, task_->hand.seed);
}

void SimulatedDevice::hold_elsewhere() {
  HeldHandle::Figures figures;
  for (std::size_t axis = 0; axis < 6; ++axis) {
    const auto i = static_cast<Eigen::Index>(axis);
    figures.mass[i] = axes_[axis].mass;
    figures.damping[i] = axes_[axis].damping;
    figures.friction[i] = axes_[axis].friction;
  }
  figures.hand_mass = task_->hand.mass;
  figures.stiffness = task_->hand.stiffness;
  figures.hand_damping = task_->hand.damping;
  figures.angular_stiffness = task_->hand.angular_stiffness;
  figures.angular_damping = task_->hand.angular_damping;
  held_.emplace(figures, X_DH_);
}

void SimulatedDevice::push(const Vec3& v_D) noexcept {
  for (std::size_t axis = 0; axis < 3; ++axis) axes_[axis].v = v_D[static_cast<Eigen::Index>(axis)];
  if (held_) held_->push(v_D);
}

DeviceSample SimulatedDevice::read() noexcept {
  const auto age = static_cast<std::size_t>(desc_.sample_age_ticks);
  DeviceSample sample;
  const Seen& seen = seen_[(at_ + kDelay - age) % kDelay];
  sample.X_DH = seen.X_DH;
  sample.age = desc_.sample_age_ticks * desc_.tick_s;
  sample.strip_ohm = seen.strip_ohm;
  if (task_) sample.buttons = task_->path.buttons(time_);
  return sample;
}

void SimulatedDevice::write(const DeviceCommand& command) noexcept {
  sent_[at_] = command;
  const auto delay = static_cast<std::size_t>(desc_.bus_delay_ticks);
  const DeviceCommand& due = sent_[(at_ + kDelay - delay) % kDelay];
  const Wrench& F = due.F_H_D;
  advance({clamp_norm(F.force, desc_.device.max_force), clamp_norm(F.torque, desc_.device.max_torque)},
          due.cues);
  at_ = (at_ + 1) % kDelay;
  measure();
}

void SimulatedDevice::miss(int ticks) noexcept {
  const DeviceCommand& held = sent_[(at_ + kDelay - 1) % kDelay];
  for (int n = 1; n <= ticks; ++n) advance(held.F_H_D * held_fraction(n * desc_.tick_s), held.cues);
  measure();
}

void SimulatedDevice::measure() noexcept {
  if (strip_) {
    const Grip grip = task_->path.grip(time_);
    seen_[at_].strip_ohm = strip_->advance(grip.hold, grip.press);
  }
  measured_.p = stepped(X_DH_.p, desc_.device.encoder_step);
  seen_[at_].X_DH = measured_;
  if (!desc_.device.senses_rotation) return;
  const Vec3 turned = rotation_vector(X_DH_.q * measured_.q.conjugate());
  measured_.q = (quaternion_exp(stepped(turned, desc_.device.encoder_step_rad)) * measured_.q).normalized();
  seen_[at_].X_DH = measured_;
}

SimulatedDevice::HandTarget SimulatedDevice::hand_target(double time, double step) const noexcept {
  const auto pose = [this](double t, const Quat& turn) {
    Pose X_WT = task_->path.at(t);
    X_WT.p += task_->sag_W;
    if (task_->mapping.drift > 0) X_WT.p -= drifted_W_;
    Pose X_DH = task_->mapping.handle_in_device(X_WT * task_->X_HT.inverse());
    const Vec6 shake = tremor_->at(t);
    X_DH.p += shake.head<3>();
    X_DH.q = quaternion_exp(shake.tail<3>()) * X_DH.q;
    if (yielding_) X_DH.q = turn * X_DH.q;
    return X_DH;
  };
  HandTarget target;
  const Quat still = Quat::Identity();
  target.X_DH = pose(time, yielding_ ? yielding_->turn_before() : still);
  const Pose next = pose(time + step, yielding_ ? yielding_->turn() : still);
  target.rate.head<3>() = (next.p - target.X_DH.p) / desc_.tick_s;
  target.rate.tail<3>() = rotation_vector(next.q * target.X_DH.q.conjugate()) / desc_.tick_s;
  return target;
}

void SimulatedDevice::advance(const Wrench& F_H_D, const DeviceCommand::Cues& cues) noexcept {
  Wrench force_D = F_H_D;
  HandTarget target;
  // One who pressed the stop button on the way knows when to go on; who was stopped by another waits.
  const bool waits = task_ && cues.paused && task_->path.buttons(time_) == 0;
  const double step = waits ? 0.0 : desc_.tick_s;
  if (task_) {
    force_D.force += task_->carried_D - desc_.device.handle_weight * Vec3::UnitY();
    if (yielding_) yielding_->advance(cues);
    drifted_W_ = cues.drifted_W;
    target = hand_target(time_, step);
  }
  if (held_)
    advance_held(force_D, target);
  else
    advance_axes(force_D, target);
  time_ += step;
}

// What the hand carries it carries where it holds.
void SimulatedDevice::advance_held(const Wrench& F_H_D, const HandTarget& target) noexcept {
  const Vec3 p_HG = task_->path.grip(time_).hold * task_->stick_H;
  Wrench force_D = F_H_D;
  force_D.torque += (X_DH_.q * p_HG).cross(task_->carried_D);
  held_->advance({.F_H_D = force_D,
                  .p_HG = p_HG,
                  .X_DH_wanted = target.X_DH,
                  .V_wanted = {target.rate.head<3>(), target.rate.tail<3>()}},
                 desc_.tick_s);
  X_DH_ = held_->X_DH();
}

void SimulatedDevice::advance_axes(const Wrench& F_H_D, const HandTarget& target) noexcept {
  Vec6 force, hand_x = Vec6::Zero(), hand_v = Vec6::Zero();
  force << F_H_D.force, F_H_D.torque;
  if (task_) {
    hand_x << target.X_DH.p, rotation_vector(target.X_DH.q * X_DH_.q.conjugate());
    hand_v = target.rate;
  }
  // A handle that is not alike about all axes turns about its own; that they turn with it is left out.
  const Quat q_DA = turns_alike_ ? Quat::Identity() : X_DH_.q;
  if (!turns_alike_)
    for (Vec6* of : {&force, &hand_x, &hand_v}) of->tail<3>() = q_DA.conjugate() * of->tail<3>();
  Vec3 turn = Vec3::Zero();
  for (std::size_t axis = 0; axis < 6; ++axis) {
    const auto i = static_cast<Eigen::Index>(axis);
    const bool linear = axis < 3;
    if (!linear) axes_[axis].x = 0;
    FrictionAxis::Load load;
    load.force = force[i];
    if (task_) {
      load.stiffness = linear ? task_->hand.stiffness : task_->hand.angular_stiffness;
      load.hand_damping = linear ? task_->hand.damping : task_->hand.angular_damping;
      load.hand_x = hand_x[i];
      load.hand_v = hand_v[i];
    }
    axes_[axis].advance(load, desc_.tick_s);
    if (linear)
      X_DH_.p[i] = axes_[axis].x;
    else
      turn[i - 3] = axes_[axis].x;
  }
  if (turn.isZero(0)) return;
  if (!turns_alike_) turn = q_DA * turn;
  X_DH_.q = (quaternion_exp(turn) * X_DH_.q).normalized();
}

}  // namespace fulcrum
