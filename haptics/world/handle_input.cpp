#include "haptics/world/handle_input.h"

#include <algorithm>
#include <cmath>

#include "haptics/device/workspace_drift.h"
#include "haptics/math/rotation.h"
#include "haptics/safety/faults.h"

namespace fulcrum {
namespace {

constexpr double kFarthestWay = 0.02;  // m, of a hand in a tick: what is farther is a device's error
constexpr double kFirstReading = 0.1;  // s, from the start: by then a strip has been read and trusted

std::optional<HoldingPoint> build_holding_point(const PlainScene& scene) {
  if (!scene.holding_point) return std::nullopt;
  HoldingPointDesc holding = *scene.holding_point;
  holding.measured = holding.measured && scene.device.strip;
  return HoldingPoint(holding, scene.device.strip, scene.tick_s);
}

}  // namespace

Vec6 encoder_steps(const DeviceDesc& device) {
  Vec6 step;
  step.head<3>().setConstant(device.encoder_step);
  step.tail<3>().setConstant(device.encoder_step_rad);
  return step;
}

HandleInput::HandleInput(const PlainScene& scene, bool pushed_clutched)
    : mapping_(scene.mapping),
      X_HT_(scene.tool.X_HT),
      tick_s_(scene.tick_s),
      velocity_(scene.velocity, scene.tick_s),
      counted_(encoder_steps(scene.device)),
      holding_point_(build_holding_point(scene)),
      holding_desc_(scene.holding_point),
      structure_(scene.device.structure),
      has_strip_(scene.device.strip.has_value()),
      workspace_(scene.device.workspace),
      workspace_centre_(scene.device.workspace_centre),
      renders_force_(scene.device.renders_force),
      renders_torque_(scene.device.renders_torque),
      drift_rest_(1.5 * scene.device.encoder_step),
      counts_at_device_(pushed_clutched || scene.mapping.drift > 0),
      engages_(scene.mapping.engages_at_start) {
  X_WH_ = scene.tool.X_WT_start * X_HT_.inverse();
  X_DH_ = mapping_.handle_in_device(X_WH_);
}

void HandleInput::apply(const Command& command) noexcept {
  if (!holding_point_) return;
  if (command.kind == Command::Kind::hold_at && std::isfinite(command.value))
    holding_point_->tell(std::clamp(command.value, holding_desc_->low, holding_desc_->high));
  if (command.kind == Command::Kind::hold_measured && has_strip_) holding_point_->measure(command.value > 0);
}

Pose HandleInput::map(const DeviceSample& sample, bool usable) noexcept {
  if (usable) {
    X_DH_ = sample.X_DH;
    X_DH_.q.normalize();
  }
  const Pose raw = mapping_.handle_in_world(X_DH_);
  const int button = mapping_.clutch_button;
  const bool held = button >= 0 && (sample.buttons >> button & 1u) != 0;
  const bool engages = engages_ && usable;
  if (engages) engages_ = false;
  if (held || clutched_ ||
      engages) {  // on release, too: from there on the offset carries the tool on from where it is
    clutch_X_.q = (raw.q.conjugate() * X_WH_.q).normalized();
    clutch_X_.p = X_WH_.p - raw.p;
  }
  const bool changed = held != clutched_ || engages;
  clutched_ = held;
  reaches_ = !held && !changed;
  if (mapping_.drift > 0) drift(usable);
  // The turn is added on the handle's side: the tool turns about the axis in the world about which the hand
  // turns, and a torque does the same work on both.
  Pose X_WH{(raw.q * clutch_X_.q).normalized(), raw.p + clutch_X_.p};
  if (held || changed) velocity_.reset(X_WH);
  return X_WH;
}

// Only while the tool is free: then it can press on nothing. What the tool gains by it in speed or height the
// hand has not put in; the passivity observer is told of the handle's own way and sees that
// (docs/held-devices.md). A way counts once it is longer than 1.5 encoder steps, and not if it is longer than
// kFarthestWay; either way the next one begins where it ended.
void HandleInput::drift(bool usable) noexcept {
  if (!usable || !drift_from_D_) {  // what lies between is no way of a hand's
    drift_from_D_ = usable ? std::optional(X_DH_.p) : std::nullopt;
    return;
  }
  const Vec3 dp_D = X_DH_.p - *drift_from_D_;
  const double way = dp_D.norm();
  if (way <= drift_rest_) return;  // not yet: counts may toggle while the handle rests
  drift_from_D_ = X_DH_.p;
  if (!reaches_ || !free_ || way > kFarthestWay) return;
  const Vec3 shift_D = workspace_drift(mapping_.drift, X_DH_.p - workspace_centre_, dp_D, workspace_);
  const Vec3 shift_W = mapping_.position_scale * (mapping_.X_WD.q * shift_D);
  clutch_X_.p += shift_W;
  drifted_W_ += shift_W;
}

// On an axis without a motor nothing is held: what the hand puts in there winds a spring, and it winds none
// while the tool does not follow it.
Vec6 HandleInput::moved_at_device(const Pose& X_DH_before) const noexcept {
  if (!known_) return Vec6::Zero();
  Vec6 moved_D;
  moved_D << X_DH_.p - X_DH_before.p, rotation_vector(X_DH_.q * X_DH_before.q.conjugate());
  if (!reaches_ && !renders_force_) moved_D.head<3>().setZero();
  if (!reaches_ && !renders_torque_) moved_D.tail<3>().setZero();
  return moved_D;
}

void HandleInput::hold(double strip_ohm, std::uint32_t& faults) noexcept {
  stiffness_limit_ = 0;
  if (!holding_point_) return;
  strip_ohm_ = strip_ohm;
  holding_point_->update(strip_ohm);
  const HoldingState state = holding_point_->state();
  const bool known = state == HoldingState::set || state == HoldingState::measured;
  if (!known && static_cast<double>(ticks_) * tick_s_ >= kFirstReading) faults |= kHoldingPointLost;
}

HandleMotion HandleInput::follow(const DeviceSample& sample, std::uint32_t& faults) noexcept {
  const bool usable = (faults & (kNotFinite | kDeviceLost)) == 0;
  const Pose X_DH_before = X_DH_;
  const Pose X_WH = map(sample, usable);
  Vec6 moved;
  moved << X_WH.p - X_WH_.p, rotation_vector(X_WH.q * X_WH_.q.conjugate());
  X_WH_ = X_WH;

  HandleMotion motion;
  motion.X_DH = X_DH_;
  motion.X_WH = X_WH;
  motion.moved_D = counts_at_device_ ? moved_at_device(X_DH_before) : mapping_.motion_in_device(moved);
  motion.drifted_W = drifted_W_;
  const bool jumps = found_anew_ || motion.moved_D.head<3>().norm() > kFarthestWay;
  known_ = known_ || usable;
  found_anew_ = !usable;
  if (jumps)
    counted_.jump(motion.moved_D);
  else
    counted_.update(motion.moved_D);
  motion.within_tick_D = counted_.within_tick();
  motion.per_tick_D = counted_.per_tick();
  motion.sample_age = sample.age;
  motion.engaged = !clutched_;
  // A clutch begins the velocity anew, from where the handle is now.
  motion.V_WH = reaches_ ? velocity_.update(X_WH, moved) : velocity_.update(X_WH);
  motion.X_WG = X_WH * X_HT_;
  motion.V_WG = {motion.V_WH.v + motion.V_WH.w.cross(Vec3(motion.X_WG.p - X_WH.p)), motion.V_WH.w};

  hold(sample.strip_ohm, faults);
  ++ticks_;
  if (holding_point_) {
    motion.place = holding_point_->place();
    motion.p_TG = X_HT_.q.conjugate() * (holding_point_->p_HG() - X_HT_.p);
    motion.p_HG_D = X_DH_.q * holding_point_->p_HG() / mapping_.position_scale;
  }
  return motion;
}

void HandleInput::touch(const ContactCentroid& centroid) noexcept {
  if (!holding_point_ || !centroid.any || !structure_) return;
  stiffness_limit_ = stiffness_at(*structure_, centroid.p_HC / mapping_.position_scale, centroid.nhat_H) /
                     (mapping_.position_scale * mapping_.force_scale);
}

std::optional<HoldingRecord> HandleInput::holding() const noexcept {
  if (!holding_point_) return std::nullopt;
  return HoldingRecord{holding_point_->place(), holding_point_->p_HG(), holding_point_->state(), strip_ohm_,
                       stiffness_limit_};
}

}  // namespace fulcrum
