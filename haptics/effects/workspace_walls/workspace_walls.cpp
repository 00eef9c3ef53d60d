#include "haptics/effects/workspace_walls/workspace_walls.h"

namespace fulcrum {
namespace {

constexpr double kMarginShare = 0.2;  // of the workspace's smallest half extent

double stiffness_of(const WorkspaceWallsDesc& desc, const DeviceDesc& device, double tick_s) {
  if (desc.stiffness) return *desc.stiffness;
  return DampedSpring::suited(
      device, tick_s, WorkspaceWalls::kForceShare * device.max_force / WorkspaceWalls::margin(desc, device));
}

}  // namespace

double WorkspaceWalls::margin(const WorkspaceWallsDesc& desc, const DeviceDesc& device) {
  return desc.margin.value_or(kMarginShare * device.workspace.minCoeff());
}

WorkspaceWalls::WorkspaceWalls(const WorkspaceWallsDesc& desc, const DeviceDesc& device, double tick_s)
    : centre_D_(device.workspace_centre),
      border_D_(device.workspace.array() - margin(desc, device)),
      spring_(stiffness_of(desc, device, tick_s), kForceShare * device.max_force, device, tick_s) {}

Vec3 WorkspaceWalls::process(const Vec3& p_DH, const Vec3& per_tick_D) noexcept {
  spring_.move(per_tick_D);
  record_ = {};
  const Vec3 p_D = p_DH - centre_D_;
  const Vec3 outside_D = p_D - p_D.cwiseMax(-border_D_).cwiseMin(border_D_);
  if (outside_D.isZero(0)) return record_.force_D;
  record_.depth = outside_D.norm();
  const Vec3 dhat_D = outside_D / record_.depth;
  record_.force_D = -spring_.push(record_.depth, dhat_D) * dhat_D;
  return record_.force_D;
}

}  // namespace fulcrum
