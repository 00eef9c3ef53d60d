#pragma once
// A scene that ticks.

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "haptics/actuation/arm.h"
#include "haptics/contact/penalty.h"
#include "haptics/contact/query.h"
#include "haptics/contact/regions.h"
#include "haptics/estimate/counted_motion.h"
#include "haptics/math/result.h"
#include "haptics/safety/energy_ledger.h"
#include "haptics/safety/guard.h"
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

// One tick: read, estimate, query, solve, couple, allocate, guard. The only function that advances a World,
// live, offline, in replay, test and benchmark alike. May: read the sample and the commands, change the
// World. Must not and does not: lock, read a clock, touch a file, allocate, throw.
StepResult step(World& world, const DeviceSample& sample, std::span<const Command> commands) noexcept;

// A part of a World, for `fulcrum explain`.
struct BuiltPart {
  std::string name;
  std::string what;
  std::size_t bytes = 0;
};

class World {
public:
  // Refused with a sentence: no shell or field, gains that the tick cannot hold, figures that are not finite.
  static Result<World> build(SceneDesc desc);

  const SceneDesc& desc() const { return desc_; }
  std::span<const ContactRegion> regions() const { return regions_.regions(); }
  std::vector<BuiltPart> parts() const;

private:
  explicit World(SceneDesc desc);
  friend StepResult step(World& world, const DeviceSample& sample,
                         std::span<const Command> commands) noexcept;

  Pose follow_handle(const DeviceSample& sample, std::uint32_t faults) noexcept;
  Wrench contact_wrench(std::uint32_t& faults) noexcept;
  void move_tool(const Wrench& F_T_W, std::uint32_t& faults) noexcept;

  SceneDesc desc_;
  RigidBody body_;
  VelocityEstimator velocity_;
  ContactQuery query_;
  PenaltyResponse response_;
  RegionTracker regions_;
  VirtualCoupling coupling_;
  DeviceArm arm_;
  Guard guard_;
  CountedMotion counted_;
  EnergyLedger ledger_;
  PassivityControl passivity_;

  ContactSet contacts_;
  BodyState tool_;
  std::int64_t tick_ = 0;
  double motion_allowance_;  // m, see ContactQuery::safe_fraction
  Pose X_DH_good_;           // the last handle pose that could be used
  Pose clutch_X_;            // what the clutch has added: X_WH = X_WD' X_DH
  Pose X_WH_;
  Twist V_WH_;
  bool clutched_ = false;
};

}  // namespace fulcrum
