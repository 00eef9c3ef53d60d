#pragma once
// Direct rendering: the tool is where the hand wants it. In each contact region a spring pulls the deepest
// point to its proxy on the surface, and the hand feels that at once: no tool between, no coupling.
//     f = k d nhat,   d the deepest point's depth, nhat the field's normal there
// That is minus the gradient of k d^2 / 2, so that a region gives back what was put in, and its stiffness is
// k whatever else of the tool is inside. The deepest point of a region may change from one tick to the next:
// its depth does so without a step, and its lever by no more than the spacing of the shell.

#include <array>

#include "haptics/contact/query.h"
#include "haptics/contact/regions.h"
#include "haptics/motion/tool_motion.h"
#include "haptics/scene/plain_scene.h"

namespace fulcrum {

class DirectMotion final : public ToolMotion {
public:
  explicit DirectMotion(const PlainScene& desc);

  ToolAnswer advance(const Pose& X_WG, const Twist& V_WG, std::uint32_t& faults) noexcept override;
  bool stiffen(double stiffness) noexcept override;
  const BodyState& tool() const override { return tool_; }
  Touching touching() const override { return regions_.touching(contacts_.contacts()); }
  double depth_max() const override { return contacts_.depth_max(); }
  double stored_energy() const noexcept override { return stored_; }
  std::vector<BuiltPart> parts() const override;

private:
  Wrench contact_wrench() noexcept;

  double stiffness_;  // N/m, of each region
  double scale_;      // of that, what the device renders of 1
  double weight_;     // N
  ContactQuery query_;
  RegionTracker regions_;
  ContactSet contacts_;
  std::array<Vec3, kMaxContacts> forces_;  // (touching x 3) N, of the deepest of each region
  BodyState tool_;
  double stored_ = 0;  // J, in the springs
};

}  // namespace fulcrum
