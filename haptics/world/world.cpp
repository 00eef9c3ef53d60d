#include "haptics/world/world.h"

#include <algorithm>
#include <utility>

#include "haptics/math/rotation.h"

namespace fulcrum {
namespace {

constexpr double kGravity = 9.80665;          // m/s^2
constexpr double kLargestAllowance = 0.5e-3;  // m

// A wall thinner than this many allowances could be passed in one tick.
constexpr double kAllowancesPerWall = 8;

double motion_allowance(const DistanceField& field) {
  const double thinnest = field.thinnest_feature_m();
  return thinnest > 0 ? std::min(kLargestAllowance, thinnest / kAllowancesPerWall) : 0.5 * field.voxel_m();
}

// (6) m and rad in W, of one count of the device.
Vec6 encoder_steps(const SceneDesc& desc) {
  Vec6 step;
  step.head<3>().setConstant(desc.mapping.position_scale * desc.device.encoder_step);
  step.tail<3>().setConstant(desc.device.encoder_step_rad);
  return step;
}

}  // namespace

World::World(SceneDesc desc)
    : desc_(std::move(desc)),
      body_(desc_.tool.mass, desc_.tool.inertia_T),
      velocity_(desc_.velocity, desc_.tick_s),
      query_(desc_.tool_shell, desc_.scene_field),
      response_(desc_.contact, body_, desc_.tick_s, desc_.integrator),
      regions_(desc_.contact.region_radius),
      coupling_(desc_.coupling, body_),
      arm_(desc_.device),
      guard_(desc_.device, desc_.tick_s),
      counted_(encoder_steps(desc_)),
      ledger_(desc_.mapping.force_scale / desc_.mapping.position_scale, desc_.device.renders_force,
              desc_.device.renders_torque),
      passivity_(desc_.device, desc_.tick_s),
      motion_allowance_(motion_allowance(*desc_.scene_field)) {
  tool_.X_WT = desc_.tool.X_WT_start;
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

Wrench World::contact_wrench(std::uint32_t& faults) noexcept {
  const ContactQuery::Outcome outcome = query_.run(tool_.X_WT, contacts_);
  if (!outcome.complete) faults |= kContactsReduced;
  if (!outcome.in_band) faults |= kToolInside;
  const PenaltyResponse::Answer answer = response_.push(contacts_, tool_);
  if (answer.stiffness_capped) faults |= kStiffnessCapped;
  regions_.update(contacts_, response_.forces(), tool_);
  return answer.F_T_W;
}

void World::move_tool(const Wrench& F_T_W, std::uint32_t& faults) noexcept {
  const double tick_s = desc_.tick_s;
  Twist V_WT;
  switch (desc_.integrator) {
    case Integrator::semi_implicit_euler:
      V_WT = body_.accelerate(tool_, F_T_W, tick_s);
      break;
    case Integrator::implicit_euler: {
      Linearisation around;
      response_.linearise(contacts_, tool_, around);
      coupling_.linearise(tool_, around);
      V_WT = body_.accelerate(tool_, F_T_W, around, tick_s);
      break;
    }
  }
  const double safe = query_.safe_fraction(V_WT.v.norm() * tick_s, V_WT.w.norm() * tick_s, motion_allowance_);
  if (safe < 1.0) {
    faults |= kMotionLimited;
    V_WT.v *= safe;
    V_WT.w *= safe;
  }
  const Pose X_WT = RigidBody::advance(tool_.X_WT, V_WT, tick_s);
  if (!X_WT.is_finite() || !V_WT.v.allFinite() || !V_WT.w.allFinite()) {
    faults |= kNotFinite;
    tool_.V_WT = {};
    return;
  }
  tool_.X_WT = X_WT;
  tool_.V_WT = V_WT;
}

StepResult step(World& w, const DeviceSample& sample, std::span<const Command> commands) noexcept {
  const SceneDesc& desc = w.desc_;

  // Read.
  std::uint32_t faults = w.guard_.watch(sample, commands);
  const Pose X_WH = w.follow_handle(sample, faults);
  Vec6 moved;
  moved << X_WH.p - w.X_WH_.p, rotation_vector(X_WH.q * w.X_WH_.q.conjugate());
  w.counted_.update(moved);
  w.X_WH_ = X_WH;

  // Estimate.
  w.V_WH_ = w.velocity_.update(w.X_WH_);

  // Query and solve, at the pose that the tick before left behind.
  const Wrench contact_F_T_W = w.contact_wrench(faults);

  // Couple.
  const Pose X_WG = w.X_WH_ * desc.tool.X_HT;
  const Twist V_WG{w.V_WH_.v + w.V_WH_.w.cross(Vec3(X_WG.p - w.X_WH_.p)), w.V_WH_.w};
  const Wrench coupling_F_T_W = w.coupling_.pull(X_WG, V_WG, w.tool_);
  const Vec3 p_TH_W = -(w.tool_.X_WT.q * (desc.tool.X_HT.q.conjugate() * desc.tool.X_HT.p));
  const Wrench F_H_W = (-coupling_F_T_W).moved_by(p_TH_W);

  const double weight = desc.tool.weight ? desc.tool.mass * kGravity : 0.0;
  Wrench F_T_W = coupling_F_T_W + contact_F_T_W;
  F_T_W.force.y() -= weight;
  const double height_before = w.tool_.X_WT.p.y();
  w.move_tool(F_T_W, faults);
  if ((faults & kStoppingFaults) != 0) w.guard_.stop(faults & kStoppingFaults);
  faults |= w.guard_.reason();

  // Guard and allocate. The device's own weight is held up here, so that the hand feels the tool's alone.
  const Wrench wanted_F_H_W = w.clutched_ ? Wrench{} : F_H_W;
  Wrench wanted_F_H_D = desc.mapping.wrench_in_device(wanted_F_H_W);
  if (!desc.device.renders_force) wanted_F_H_D.force.setZero();
  if (!desc.device.renders_torque) wanted_F_H_D.torque.setZero();
  const Wrench resistance =
      w.passivity_.resist(w.ledger_.deficit(), desc.mapping.motion_in_device(w.counted_.per_tick()));
  if (!resistance.is_zero()) faults |= kPassivityControl;
  wanted_F_H_D += resistance;
  Wrench own_weight;
  if (desc.device.renders_force)
    own_weight.force = desc.mapping.X_WD.q.conjugate() * Vec3(0, desc.device.handle_weight, 0);
  const Wrench limited_F_H_D = w.guard_.limit(wanted_F_H_D + own_weight, faults);
  const Allocation allocation = allocate(w.arm_, w.X_DH_good_, limited_F_H_D);
  if (allocation.clamped) faults |= kMotorClamped;
  w.guard_.commanded(allocation.command.F_H_D);

  // Book what the hand did, against what it felt and feels from here on.
  Wrench felt_F_H_W = desc.mapping.wrench_in_world(allocation.command.F_H_D + own_weight * -w.guard_.gain());
  if (!desc.device.renders_force) felt_F_H_W.force = wanted_F_H_W.force * w.guard_.gain();
  if (!desc.device.renders_torque) felt_F_H_W.torque = wanted_F_H_W.torque * w.guard_.gain();
  w.ledger_.book(moved, w.counted_.within_tick(),
                 {.F_H_W = felt_F_H_W,
                  .weight = weight * height_before,
                  .springs = w.coupling_.stored() + w.body_.kinetic_energy(w.tool_),
                  .open = w.guard_.gain() >= 1.0});
  if (w.ledger_.port() < kPortBound) faults |= kEnergyBound;

  StepResult result;
  result.command = allocation.command;
  TickRecord& record = result.record;
  record.tick = w.tick_++;
  record.X_WH = w.X_WH_;
  record.X_WT = w.tool_.X_WT;
  record.V_WT = w.tool_.V_WT;
  record.coupling_F_T_W = coupling_F_T_W;
  record.contact_F_T_W = contact_F_T_W;
  record.regions = static_cast<std::int32_t>(w.regions_.regions().size());
  record.depth_max = w.contacts_.depth_max();
  record.device_F_H_D = allocation.command.F_H_D;
  record.actuator_load = allocation.load;
  record.energy_port = w.ledger_.port();
  record.energy_unrendered = w.ledger_.unrendered();
  record.force_gain = w.guard_.gain();
  record.faults = faults;
  record.stopped = w.guard_.stopped();
  record.clutched = w.clutched_;
  return result;
}

}  // namespace fulcrum
