#pragma once
// A tool without mass between two springs: where the coupling and the penalty of the contact regions balance.
// Each tick is a few steps of Newton's method,
//     (K_c + K_contact) dq = F_c + F_contact + weight,
// each cut so that no shell point can have passed a wall. M. Wan, W. A. McNeely, "Quasi-static approximation
// for 6 degrees-of-freedom haptic rendering", IEEE Visualization 2003.

#include <optional>

#include "haptics/contact/penalty.h"
#include "haptics/contact/query.h"
#include "haptics/contact/region_friction.h"
#include "haptics/contact/regions.h"
#include "haptics/motion/quasi_static_tool.h"
#include "haptics/motion/tool_motion.h"

namespace fulcrum {

class QuasiStaticMotion final : public ToolMotion {
public:
  explicit QuasiStaticMotion(const PlainScene& desc);

  ToolAnswer advance(const Pose& X_WG, const Twist& V_WG, std::uint32_t& faults) noexcept override;
  void limit_torque(double limit) noexcept override { tool_.limit_torque(limit); }
  bool stiffen(double stiffness) noexcept override;
  const BodyState& tool() const override { return tool_.state(); }
  Touching touching() const override { return regions_.touching(contacts_.contacts()); }
  double depth_max() const override { return contacts_.depth_max(); }
  double stored_energy() const noexcept override { return tool_.coupling().stored(); }
  std::vector<BuiltPart> parts() const override;

private:
  Vec6 newton_step(const Pose& X_WG) noexcept;
  Wrench contact_wrench(const BodyState& tool) noexcept;

  CouplingDesc coupling_;
  QuasiStaticTool tool_;
  ContactQuery query_;
  PenaltyResponse response_;
  std::optional<RegionFriction> friction_;  // where the scene names it
  RegionTracker regions_;
  double allowance_;  // m, see motion_allowance()
  double tool_radius_;
  bool looked_ = false;
  ContactQuery::Outcome outcome_;
  ContactSet contacts_;
};

}  // namespace fulcrum
