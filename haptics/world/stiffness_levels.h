#pragma once
// How stiff the scene is, where a person may choose among levels.

#include "haptics/contact/contact_desc.h"
#include "haptics/motion/tool_motion.h"
#include "haptics/tick/command.h"

namespace fulcrum {

class StiffnessLevels {
public:
  explicit StiffnessLevels(const ContactDesc& contact)
      : levels_(contact.levels), wanted_(contact.stiffness), now_(contact.stiffness) {}

  void apply(const Command& command) noexcept;
  // Sets the chosen level as soon as nothing is touched: a spring that is pressed would gain energy.
  void set(ToolMotion& motion) noexcept;

  double wanted() const { return wanted_; }  // N/m, of each region
  double now() const { return now_; }

private:
  std::vector<double> levels_;
  double wanted_, now_;
};

}  // namespace fulcrum
