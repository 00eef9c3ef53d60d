#pragma once
// How a tool answers, in one tick, to where the hand wants it and to what it touches. One of these is built
// for a scene: the one that its contact response names.

#include <cstdint>
#include <span>
#include <vector>

#include "haptics/contact/regions.h"
#include "haptics/math/wrench.h"
#include "haptics/scene/built_part.h"
#include "haptics/tick/tool_answer.h"
#include "haptics/tool/rigid_body.h"

namespace fulcrum {

class ToolMotion {
public:
  virtual ~ToolMotion() = default;

  // One tick. X_WG, V_WG: where and how fast the hand wants the tool. Adds the bits of what went wrong or was
  // limited. May: change the tool's state. Must not: allocate, lock, throw.
  virtual ToolAnswer advance(const Pose& X_WG, const Twist& V_WG, std::uint32_t& faults) noexcept = 0;

  // The coupling's torque from the next tick on: N m, infinity for no limit. Nothing to do where contact is
  // no spring.
  virtual void limit_torque(double) noexcept {}

  // Where on the tool the hand holds it from the next tick on: p_TG (3) m, in T. The coupling's spring is
  // there. Nothing to do where a coupling holds the tool by T, or where there is none.
  virtual void hold_at(const Vec3& /*p_TG*/) noexcept {}

  // N/m, of each contact region from the next tick on. False, and nothing is changed: the scene is touched,
  // and a spring that is pressed would gain energy; or contact has none.
  virtual bool stiffen(double /*stiffness*/) noexcept { return false; }

  virtual const BodyState& tool() const = 0;
  virtual Touching touching() const = 0;  // as the last advance() found it, at the pose of its answer
  std::span<const ContactRegion> regions() const { return touching().regions; }
  virtual double depth_max() const = 0;  // m, deepest shell point at the last query
  // J, what the coupling's springs and the tool's motion can give back now.
  virtual double stored_energy() const noexcept = 0;
  virtual std::vector<BuiltPart> parts() const = 0;
};

}  // namespace fulcrum
