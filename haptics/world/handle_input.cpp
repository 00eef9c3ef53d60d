#include "haptics/world/handle_input.h"

#include <algorithm>
#include <cmath>

#include "haptics/math/rotation.h"
#include "haptics/safety/faults.h"

namespace fulcrum {
namespace {

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

HandleInput::HandleInput(const PlainScene& scene)
    : mapping_(scene.mapping),
      X_HT_(scene.tool.X_HT),
      tick_s_(scene.tick_s),
      velocity_(scene.velocity, scene.tick_s),
      counted_(encoder_steps(scene.device)),
      holding_point_(build_holding_point(scene)),
      holding_desc_(scene.holding_point),
      structure_(scene.device.structure),
      has_strip_(scene.device.strip.has_value()),
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
  // The turn is added on the handle's side: the tool turns about the axis in the world about which the hand
  // turns, and a torque does the same work on both.
  Pose X_WH{(raw.q * clutch_X_.q).normalized(), raw.p + clutch_X_.p};
  if (held || changed) velocity_.reset(X_WH);
  return X_WH;
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
  const Pose X_WH = map(sample, (faults & (kNotFinite | kDeviceLost)) == 0);
  Vec6 moved;
  moved << X_WH.p - X_WH_.p, rotation_vector(X_WH.q * X_WH_.q.conjugate());
  X_WH_ = X_WH;

  HandleMotion motion;
  motion.X_DH = X_DH_;
  motion.X_WH = X_WH;
  motion.moved_D = mapping_.motion_in_device(moved);
  counted_.update(motion.moved_D);
  motion.within_tick_D = counted_.within_tick();
  motion.per_tick_D = counted_.per_tick();
  motion.sample_age = sample.age;
  motion.engaged = !clutched_;
  motion.V_WH = velocity_.update(X_WH);
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
