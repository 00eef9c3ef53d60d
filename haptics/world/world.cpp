#include "haptics/world/world.h"

#include <algorithm>
#include <utility>

#include "haptics/math/rotation.h"
#include "haptics/motion/build_motion.h"
#include "haptics/world/build_effects.h"

namespace fulcrum {
namespace {

// (6) m and rad in D, of one count of the device.
Vec6 encoder_steps(const DeviceDesc& device) {
  Vec6 step;
  step.head<3>().setConstant(device.encoder_step);
  step.tail<3>().setConstant(device.encoder_step_rad);
  return step;
}

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
double returnable(const Wrench& commanded_F_H_D, const Wrench& wanted_F_H_D) {
  if (wanted_F_H_D.is_zero()) return 1;
  const double force = wanted_F_H_D.force.isZero(0) ? 0 : part_of(commanded_F_H_D.force, wanted_F_H_D.force);
  const double torque =
      wanted_F_H_D.torque.isZero(0) ? 0 : part_of(commanded_F_H_D.torque, wanted_F_H_D.torque);
  const double p = std::max(force, torque);
  return p * (2 - p);
}

}  // namespace

World::World(SceneDesc desc)
    : desc_(std::move(desc)),
      motion_(build_motion(desc_)),
      velocity_(desc_.velocity, desc_.tick_s),
      motors_(desc_.device, desc_.allocation),
      guard_(desc_.device, desc_.tick_s, transient_sources(desc_)),
      output_limit_(desc_.device, desc_.tick_s),
      counted_(encoder_steps(desc_.device)),
      ledger_(encoder_steps(desc_.device), desc_.device.renders_force, desc_.device.renders_torque),
      passivity_(desc_.device, desc_.tick_s),
      torque_substitution_(build_torque_substitution(desc_)),
      impact_detector_(build_impact_detector(desc_)),
      impact_vibration_(build_impact_vibration(desc_)),
      braking_pulse_(build_braking_pulse(desc_)),
      vibrotactile_motion_(build_vibrotactile_motion(desc_)),
      holding_point_(build_holding_point(desc_)),
      inertia_compensation_(build_inertia_compensation(desc_)),
      stiffness_wanted_(desc_.contact.stiffness),
      stiffness_(desc_.contact.stiffness) {
  X_WH_ = desc_.tool.X_WT_start * desc_.tool.X_HT.inverse();
  X_DH_good_ = desc_.mapping.handle_in_device(X_WH_);
}

// Clutch and mapping. A sample that cannot be used leaves the handle where it was.
Pose World::follow_handle(const DeviceSample& sample, std::uint32_t faults) noexcept {
  if ((faults & (kNotFinite | kDeviceLost)) == 0) {
    X_DH_good_ = sample.X_DH;
    X_DH_good_.q.normalize();
  }
  const Pose raw = desc_.mapping.handle_in_world(X_DH_good_);
  const int button = desc_.mapping.clutch_button;
  const bool held = button >= 0 && (sample.buttons >> button & 1u) != 0;
  if (held || clutched_) {  // on release, too: from there on the offset carries the tool on from where it is
    clutch_X_.q = (X_WH_.q * raw.q.conjugate()).normalized();
    clutch_X_.p = X_WH_.p - raw.p;
  }
  const bool changed = held != clutched_;
  clutched_ = held;
  const Pose X_WH{(clutch_X_.q * raw.q).normalized(), raw.p + clutch_X_.p};
  if (held || changed) velocity_.reset(X_WH);
  return X_WH;
}

StepResult step(World& w, const DeviceSample& sample, std::span<const Command> commands) noexcept {
  const SceneDesc& desc = w.desc_;

  // Read.
  std::uint32_t faults = w.guard_.watch(sample, commands);
  w.obey(commands);
  const Pose X_WH = w.follow_handle(sample, faults);
  Vec6 moved;
  moved << X_WH.p - w.X_WH_.p, rotation_vector(X_WH.q * w.X_WH_.q.conjugate());
  const Vec6 moved_D = desc.mapping.motion_in_device(moved);
  w.counted_.update(moved_D);
  w.X_WH_ = X_WH;

  // Estimate.
  w.V_WH_ = w.velocity_.update(w.X_WH_);

  w.hold(sample, faults);

  // Query, solve and couple.
  const Pose X_WG = w.X_WH_ * desc.tool.X_HT;
  const Twist V_WG{w.V_WH_.v + w.V_WH_.w.cross(Vec3(X_WG.p - w.X_WH_.p)), w.V_WH_.w};
  const ToolAnswer answer = w.motion_->advance(X_WG, V_WG, faults);
  const Vec3 p_TH_W = -(answer.X_WT.q * (desc.tool.X_HT.q.conjugate() * desc.tool.X_HT.p));
  const Wrench F_H_W = (-answer.coupling_F_T_W).moved_by(p_TH_W);
  if ((faults & kStoppingFaults) != 0) w.guard_.stop(faults & kStoppingFaults);
  faults |= w.guard_.reason();

  // Events.
  if (w.impact_detector_)
    w.impact_detector_->process(
        {.X_WT = answer.X_WT, .X_WG = X_WG, .V_WG = V_WG, .touching = w.motion_->touching()});

  const World::Touched touched = w.touched(answer.X_WT);
  if (w.holding_point_ && touched.any && desc.device.structure)
    w.stiffness_limit_ =
        stiffness_at(*desc.device.structure, touched.p_HC / desc.mapping.position_scale, touched.nhat_H) /
        (desc.mapping.position_scale * desc.mapping.force_scale);

  // Guard and allocate. The device's own weight is held up here, so that the hand feels the tool's alone.
  const Wrench wanted_F_H_W = w.clutched_ ? Wrench{} : F_H_W;
  Wrench wanted_F_H_D = desc.mapping.wrench_in_device(wanted_F_H_W);
  if (!desc.device.renders_force) wanted_F_H_D.force.setZero();
  if (!desc.device.renders_torque) wanted_F_H_D.torque.setZero();
  const Vec3 lateral_D = w.move_vibration(wanted_F_H_W, moved_D);
  if (!lateral_D.isZero(0)) wanted_F_H_D.force += lateral_D;  // or -0 would become 0
  const Wrench& resistance = w.resistance_F_H_D_ =
      w.passivity_.resist(w.ledger_.deficit(), w.counted_.per_tick());
  if (!resistance.is_zero()) faults |= kPassivityControl;
  wanted_F_H_D += resistance;
  Wrench own_weight;
  if (desc.device.renders_force)
    own_weight.force = desc.mapping.X_WD.q.conjugate() * Vec3(0, desc.device.handle_weight, 0);
  const Wrench made_up = w.make_up_for_inertia(touched, wanted_F_H_D.force);
  Wrench all_F_H_D = wanted_F_H_D + own_weight;
  if (!made_up.is_zero()) all_F_H_D += made_up;  // or -0 would become 0
  const Wrench limited_F_H_D = w.guard_.limit(all_F_H_D, faults);
  const Vec3 felt_D = limited_F_H_D.force - own_weight.force * w.guard_.gain();
  w.motors_.begin(w.X_DH_good_);
  const Allocation continuous = w.allocate_continuous(limited_F_H_D, faults);
  w.motors_.take(continuous);
  DeviceCommand command{.F_H_D = continuous.F_H_D};
  // Slew goes on from what the motors did: what they have not is missing of what was wanted before it.
  w.missing_ = (continuous.clamped() ? all_F_H_D * w.guard_.gain() : limited_F_H_D) + -continuous.F_H_D;
  w.demand_transients(answer, {X_WG, V_WG}, felt_D, answer.X_WT.p + p_TH_W);
  w.render_transients(moved_D, command.F_H_D, faults);

  // The last word on what leaves.
  OutputLimit::Output output{
      .continuous = {continuous.F_H_D, continuous.effort},
      .transient = {command.F_H_D + -continuous.F_H_D, w.motors_.taken() - continuous.effort}};
  Effort effort = w.motors_.taken();
  if (const std::uint32_t beyond = w.output_limit_.hold(output); beyond != 0) {
    command.F_H_D = output.continuous.F_H_D + output.transient.F_H_D;
    effort = output.continuous.effort + output.transient.effort;
    faults |= beyond;
    if ((beyond & kStoppingFaults) != 0) w.guard_.stop(beyond & kStoppingFaults);
  }
  w.guard_.commanded(output.continuous.F_H_D);

  // Book what the hand did, against what it felt and feels from here on.
  Wrench felt_F_H_D = output.continuous.F_H_D + own_weight * -w.guard_.gain();
  if (w.inertia_compensation_) {  // it has an account of its own
    w.inertia_compensation_->book({part_of(output.continuous.F_H_D.force, all_F_H_D.force),
                                   part_of(output.continuous.F_H_D.torque, all_F_H_D.torque)},
                                  moved_D, w.counted_.within_tick(), sample.age);
    const InertiaCues& cues = w.inertia_compensation_->cues();
    if (!cues.force_D.isZero(0)) felt_F_H_D.force -= cues.force_D;
    if (!cues.torque_D.isZero(0)) felt_F_H_D.torque -= cues.torque_D;
    if (w.inertia_compensation_->cues().faded) faults |= kCompensationFaded;
  }
  const Wrench unlimited_F_H_D = desc.mapping.wrench_in_device(wanted_F_H_W);
  if (!desc.device.renders_force) felt_F_H_D.force = unlimited_F_H_D.force * w.guard_.gain();
  if (!desc.device.renders_torque) felt_F_H_D.torque = unlimited_F_H_D.torque * w.guard_.gain();
  const double energy_scale = desc.mapping.energy_scale();
  double springs = energy_scale * w.motion_->stored_energy();
  // A force that only lags behind what is wanted is no clamp.
  if ((faults & kSlewLimited) == 0) springs *= returnable(output.continuous.F_H_D, all_F_H_D);
  w.ledger_.book(moved_D, {.F_H_D = felt_F_H_D,
                           .weight = energy_scale * tool_weight(desc.tool) * answer.X_WT.p.y(),
                           .springs = springs,
                           .open = w.guard_.gain() >= 1.0});
  if (w.ledger_.port() < kPortBound) faults |= kEnergyBound;

  StepResult result;
  if (w.torque_substitution_) {
    const TorqueCues& cues = w.torque_substitution_->cues();
    command.cues = {cues.vibration, cues.ghost, desc.mapping.X_WD.q.conjugate() * -answer.turn_W};
  }
  if (w.vibrotactile_motion_)
    command.vibrotactile = w.vibrotactile_motion_->render(w.guard_.gain(), w.guard_.stopped());
  TickRecord& record = result.record;
  for (int motor = 0; motor < w.motors_.motors(); ++motor) {
    const auto slot = static_cast<std::size_t>(motor);
    command.effort[slot] = effort[motor];
    record.actuator_load[slot] = w.motors_.load(motor, effort[motor]);
  }
  result.command = command;
  record.tick = w.tick_++;
  record.X_WH = w.X_WH_;
  record.X_WT = w.motion_->tool().X_WT;
  record.V_WT = w.motion_->tool().V_WT;
  record.coupling_F_T_W = answer.coupling_F_T_W;
  record.contact_F_T_W = answer.contact_F_T_W;
  record.regions = static_cast<std::int32_t>(w.regions().size());
  record.depth_max = w.motion_->depth_max();
  record.device_F_H_D = command.F_H_D;
  record.energy_port = w.ledger_.port();
  record.energy_unrendered = w.ledger_.unrendered();
  record.force_gain = w.guard_.gain();
  record.faults = faults;
  record.stopped = w.guard_.stopped();
  record.clutched = w.clutched_;
  w.record_effects(record);
  return result;
}

}  // namespace fulcrum
