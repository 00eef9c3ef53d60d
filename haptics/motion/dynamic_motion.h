#pragma once
// A tool with mass between two springs: the coupling to the hand and the penalty of each contact region,
// moved by a named integrator.

#include <optional>

#include "haptics/contact/penalty.h"
#include "haptics/contact/query.h"
#include "haptics/contact/region_friction.h"
#include "haptics/contact/regions.h"
#include "haptics/contact/voxel_query.h"
#include "haptics/motion/tool_motion.h"
#include "haptics/scene/plain_scene.h"
#include "haptics/tool/virtual_coupling.h"

namespace fulcrum {

class DynamicMotion final : public ToolMotion {
public:
  explicit DynamicMotion(const PlainScene& desc);

  ToolAnswer advance(const Pose& X_WG, const Twist& V_WG, std::uint32_t& faults) noexcept override;
  void limit_torque(double limit) noexcept override { coupling_.limit_torque(limit); }
  void hold_at(const Vec3& p_TG) noexcept override { coupling_.hold_at(p_TG); }
  bool stiffen(double stiffness) noexcept override;
  const BodyState& tool() const override { return tool_; }
  Touching touching() const override { return regions_.touching(contacts_.contacts()); }
  double depth_max() const override { return contacts_.depth_max(); }
  double stored_energy() const noexcept override;
  std::vector<BuiltPart> parts() const override;

private:
  Wrench contact_wrench(std::uint32_t& faults) noexcept;
  RigidBody::Move accelerated(const Wrench& F_T_W) const noexcept;
  void move(const Wrench& F_T_W, std::uint32_t& faults) noexcept;

  double tick_s_;
  Integrator integrator_;
  RigidBody body_;
  double weight_;  // N
  ContactQuery query_;
  std::optional<VoxelQuery> voxels_;  // under the response voxel; query_ then bounds the motion alone
  PenaltyResponse response_;
  std::optional<RegionFriction> friction_;  // where the scene names it
  RegionTracker regions_;
  VirtualCoupling coupling_;
  ContactSet contacts_;
  BodyState tool_;
  double motion_allowance_;
};

}  // namespace fulcrum
