#pragma once
// A tool without mass whose shell never goes in (constrained_tool.h). A tick is a few rounds of: linearise
// what is near, solve the quadratic program, go along its answer as far as no shell point can have passed a
// wall, nor an edge of the scene the tool's, look again. Points within reach_ of the scene are rows of the
// program, so that they slide along it; the others bound how far a round may go.

#include <optional>

#include "haptics/contact/query.h"
#include "haptics/motion/constrained_tool.h"
#include "haptics/motion/tool_motion.h"

namespace fulcrum {

class ConstrainedMotion final : public ToolMotion {
public:
  explicit ConstrainedMotion(const PlainScene& desc);

  ToolAnswer advance(const Pose& X_WG, const Twist& V_WG, std::uint32_t& faults) noexcept override;
  const BodyState& tool() const override { return tool_.state(); }
  Touching touching() const override { return tool_.touching(); }
  double depth_max() const override { return tool_.contacts().depth_max(); }
  double stored_energy() const noexcept override { return tool_.stored_energy(); }
  std::vector<BuiltPart> parts() const override;

private:
  void look() noexcept;
  // How much of a motion is safe, see ContactQuery::safe_fraction(); points nearer than reach_ are rows.
  double safe_fraction(double travel, double turn) const noexcept;

  ConstrainedTool tool_;
  ContactQuery query_;
  std::optional<ContactQuery> edges_;  // the scene's, against the tool
  double allowance_;                   // m, see motion_allowance()
  double reach_;                       // m, points nearer than this are rows
  bool looked_ = false;
  ContactQuery::Outcome outcome_;
};

}  // namespace fulcrum
