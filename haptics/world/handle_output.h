#pragma once
// The last stages of a tick: from the wrench that the hand should feel to a device's command. Passivity
// control, the guard's limits, allocation to motors, transients within their budgets, the output limit, and
// the passivity observer's account of what came of it. No effect passes any of these.
//
// Its functions are called once a tick, in the order in which they stand here.

#include <array>
#include <cstdint>
#include <span>

#include "haptics/actuation/allocator.h"
#include "haptics/safety/guard.h"
#include "haptics/safety/output_limit.h"
#include "haptics/safety/passivity_controller.h"
#include "haptics/safety/passivity_observer.h"
#include "haptics/safety/rendered.h"
#include "haptics/tick/command.h"
#include "haptics/tick/handle_motion.h"
#include "haptics/tick/transient.h"
#include "haptics/world/scene_desc.h"
#include "haptics/world/tick_record.h"

namespace fulcrum {

class HandleOutput {
public:
  explicit HandleOutput(const SceneDesc& desc);

  // What the sample and the commands of this tick ask for; the faults that are present now.
  std::uint32_t watch(const DeviceSample& sample, std::span<const Command> commands) noexcept;
  // Stops the force where one of the tick's faults asks for it. Adds why it is stopped.
  void stop(std::uint32_t& faults) noexcept;
  bool stopped() const { return guard_.stopped(); }
  double gain() const { return guard_.gain(); }

  // The continuous wrench as the device is to render it, on the axes that it has. F_H_W: of the coupling, on
  // the handle; nothing while the clutch is pressed.
  Wrench in_device(const Wrench& F_H_W) noexcept;
  // That wrench as it would be if the device had all axes.
  const Wrench& unlimited() const { return unlimited_F_H_D_; }
  // What passivity control adds to it. per_tick_D (6): the handle's motion.
  const Wrench& resist(const Vec6& per_tick_D, std::uint32_t& faults) noexcept;

  // Limits and allocates the continuous wrench, which holds up the device's own weight besides. correction:
  // of the device itself; the hand is not to feel it. Returns the force that it feels (3) N, in D.
  Vec3 render(const Wrench& wanted_F_H_D, const Wrench& correction_F_H_D, const HandleMotion& handle,
              std::uint32_t& faults) noexcept;
  // A transient of this tick; a source's last one counts.
  void want(const Transient& transient) noexcept;
  // Renders them in the order of TransientSource, with the motors that are left, and makes sure that what
  // leaves is within the device's limits.
  void render_transients(const Vec6& moved_D, std::uint32_t& faults) noexcept;

  const Rendered& rendered() const { return rendered_; }

  // Tells the passivity observer what the hand felt. correction: as much of it as was commanded.
  struct Stores {        // of energy, in the scene
    double height = 0;   // m, of the tool, as far as the hand has lifted it
    double springs = 0;  // J, in the coupling and in the tool's motion
    double effects = 0;  // J at the device, in springs of effects
  };
  void book(const Vec6& moved_D, const Wrench& correction_F_H_D, const Stores& stores,
            std::uint32_t& faults) noexcept;

  void leave(DeviceCommand& command, TickRecord& record) const noexcept;

  const Wrench& continuous_F_H_D() const { return guard_.last(); }  // on the handle in D, of the last tick
  const Wrench& resistance_F_H_D() const { return resistance_F_H_D_; }  // of passivity control
  const Allocator& motors() const { return motors_; }
  const TransientBudget* budget(TransientSource source) const { return guard_.budget(source); }

private:
  Allocation allocate_continuous(const Wrench& limited_F_H_D, const Vec3& p_HG_D,
                                 std::uint32_t& faults) noexcept;
  Allocation allocate_grasped(const Transient& wanted, const Vec6& moved_D, std::uint32_t& faults) noexcept;
  Allocation allocate_transient(const Transient& wanted, const Vec6& moved_D, std::uint32_t& faults) noexcept;
  void limit_output(std::uint32_t& faults) noexcept;

  MappingDesc mapping_;
  bool renders_force_, renders_torque_, grasped_;
  double tool_weight_;          // N
  Wrench handle_weight_F_H_D_;  // that holds it up
  Allocator motors_;
  Guard guard_;
  OutputLimit output_limit_;
  PassivityObserver observer_;
  PassivityController passivity_;

  // Of this tick, on the handle about H, in D.
  Wrench unlimited_F_H_D_, resistance_F_H_D_;
  Wrench all_F_H_D_;  // wanted, continuous: with the handle's weight
  Allocation continuous_;
  std::array<Transient, kTransientSources> transients_{};
  Wrench command_F_H_D_;
  Effort effort_ = Effort::Zero();
  Wrench shortfall_F_H_D_;  // of all that was wanted
  Rendered rendered_;
};

}  // namespace fulcrum
