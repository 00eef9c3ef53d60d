#pragma once
// A scene that ticks.

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "haptics/actuation/allocator.h"
#include "haptics/estimate/counted_motion.h"
#include "haptics/estimate/velocity.h"
#include "haptics/math/result.h"
#include "haptics/motion/tool_motion.h"
#include "haptics/safety/energy_ledger.h"
#include "haptics/safety/guard.h"
#include "haptics/safety/output_limit.h"
#include "haptics/safety/passivity_control.h"
#include "haptics/world/command.h"
#include "haptics/world/scene_desc.h"
#include "haptics/world/tick_record.h"

namespace fulcrum {

struct StepResult {
  DeviceCommand command;
  TickRecord record;
};

class World;

// One tick: read, estimate, query, solve, couple, events, effects, guard, allocate. The only function that
// advances a World, live, offline, in replay, test and benchmark alike. May: read the sample and the
// commands, change the World. Must not and does not: lock, read a clock, touch a file, allocate, throw.
StepResult step(World& world, const DeviceSample& sample, std::span<const Command> commands) noexcept;

class World {
public:
  // Refused with a sentence: no shell or field, gains that the tick cannot hold, figures that are not finite.
  static Result<World> build(SceneDesc desc);

  const SceneDesc& desc() const { return desc_; }
  std::span<const ContactRegion> regions() const { return motion_->regions(); }
  std::vector<BuiltPart> parts() const;
  // Of this scene's last tick; none where nothing asks for impacts.
  std::span<const Impact> impacts() const {
    return impact_detector_ ? impact_detector_->impacts() : std::span<const Impact>();
  }
  // On the handle in D, of the last tick: what was commanded without the transients.
  const Wrench& continuous_F_H_D() const { return guard_.last(); }
  // Likewise: what the passivity control wanted beside all else.
  const Wrench& resistance_F_H_D() const { return resistance_F_H_D_; }
  // Of torque; null: not built.
  const TorqueSubstitution* substitution() const {
    return torque_substitution_ ? &*torque_substitution_ : nullptr;
  }

  // Of the device's inertia; null: not built.
  const InertiaCompensation* compensation() const {
    return inertia_compensation_ ? &*inertia_compensation_ : nullptr;
  }

private:
  explicit World(SceneDesc desc);
  friend StepResult step(World& world, const DeviceSample& sample,
                         std::span<const Command> commands) noexcept;

  Pose follow_handle(const DeviceSample& sample, std::uint32_t faults) noexcept;
  Vec3 substitute_torque(const ToolAnswer& answer, const Vec3& felt_D) noexcept;
  // Fills transients_ with what the effects want on the handle in this tick. p_WH (3) m: where the tool has
  // it.
  struct Wanted {  // of the tool, by the hand
    Pose X_WG;
    Twist V_WG;
  };
  void demand_transients(const ToolAnswer& answer, const Wanted& wanted, const Vec3& felt_D,
                         const Vec3& p_WH) noexcept;
  // Of a continuous wrench that the guard has let through: what the motors can do of it, where the handle is.
  Allocation allocate_continuous(const Wrench& limited_F_H_D, std::uint32_t& faults) noexcept;
  Allocation allocate_pulse(const Wrench& commanded_F_H_D, const Vec6& moved_D,
                            std::uint32_t& faults) noexcept;
  void render_transients(const Vec6& moved_D, Wrench& commanded_F_H_D, std::uint32_t& faults) noexcept;
  // Answers the lateral force on the handle (3) N, in D. F_H_W: that it should feel, clutch or not.
  Vec3 move_vibration(const Wrench& F_H_W, const Vec6& moved_D) noexcept;
  void obey(std::span<const Command> commands) noexcept;
  void tell_holding_point(const Command& command) noexcept;
  // Where the hand holds the tool and how stiff the scene is, before the tick's query.
  void hold(const DeviceSample& sample, std::uint32_t& faults) noexcept;
  // Where the tool is touched: the centre of the forces on it, and the normal of the strongest region.
  struct Touched {
    bool any = false;
    Vec3 p_HC = Vec3::Zero();    // (3) m, in H
    Vec3 nhat_H = Vec3::Zero();  // (3) unit, towards the tool
  };
  Touched touched(const Pose& X_WT) const noexcept;
  Vec3 p_HG_D() const noexcept;  // (3) m, where the hand holds, from the handle; zero where no scene says
  // The wrench on the handle, in D. rendered_D (3) N: what it is to feel.
  Wrench make_up_for_inertia(const Touched& touched, const Vec3& rendered_D) noexcept;
  void record_effects(TickRecord& record) const noexcept;

  SceneDesc desc_;
  std::unique_ptr<ToolMotion> motion_;
  VelocityEstimator velocity_;
  Allocator motors_;
  Guard guard_;
  OutputLimit output_limit_;
  CountedMotion counted_;
  EnergyLedger ledger_;
  PassivityControl passivity_;
  std::optional<TorqueSubstitution> torque_substitution_;
  std::optional<ImpactDetector> impact_detector_;
  std::optional<ImpactVibration> impact_vibration_;
  std::optional<BrakingPulse> braking_pulse_;
  std::optional<VibrotactileMotion> vibrotactile_motion_;
  BrakingPulse::Demand pulse_;  // of this tick
  struct {
    double force = 0, moment = 0;
  } pulse_shares_;                                      // likewise
  std::array<Wrench, kTransientSources> transients_{};  // on the handle, in D; what was commanded at last

  std::optional<HoldingPoint> holding_point_;
  std::optional<InertiaCompensation> inertia_compensation_;
  double stiffness_wanted_, stiffness_;  // N/m, of a contact region
  double strip_ohm_ = kNoStrip;          // of this tick
  double stiffness_limit_ = 0;           // N/m, of the device's structure, where it is touched in this tick

  Wrench resistance_F_H_D_;
  Wrench missing_;  // of what was wanted in this tick, on the handle, in D

  std::int64_t tick_ = 0;
  Pose X_DH_good_;  // the last handle pose that could be used
  Pose clutch_X_;   // what the clutch has added: X_WH = X_WD' X_DH
  Pose X_WH_;
  Twist V_WH_;
  bool clutched_ = false;
};

}  // namespace fulcrum
