#pragma once
// The border of the workspace is felt before an arm comes to its hard stops: a box in D, a margin inside
// the device's half extents about its workspace's centre, that pushes a handle outside of it back towards
// its nearest point. With d (3) m from that point to the handle, dhat its direction and v the handle's
// velocity:
//     f = -clamp(K |d| + B v . dhat, 0, f_max) dhat
// which is a DampedSpring (device/damped_spring.h) on the way to that point: without the damper a closed way
// costs nothing and gives nothing.
//
// Where K is not given it is what suits the device, up to f_max / margin, with which the force is whole at
// the workspace's end.

#include <optional>

#include "haptics/device/damped_spring.h"
#include "haptics/device/device.h"
#include "haptics/effects/workspace_walls/workspace_walls_record.h"

namespace fulcrum {

struct WorkspaceWallsDesc {
  // m, how far inside the workspace's end they begin; without it a fifth of its smallest half extent.
  std::optional<double> margin{};
  std::optional<double> stiffness{};  // N/m at the device, K; without it what suits the device
};

inline void mirror(WorkspaceWallsDesc&) {}  // it has no sides

class WorkspaceWalls {
public:
  static constexpr double kForceShare = 0.5;  // of the device's largest force: the rest is the scene's

  static double margin(const WorkspaceWallsDesc& desc, const DeviceDesc& device);  // m

  WorkspaceWalls(const WorkspaceWallsDesc& desc, const DeviceDesc& device, double tick_s);

  // p_DH (3) m; per_tick_D (3) m per tick, the handle's motion. Returns the force on the handle (3) N, in D.
  Vec3 process(const Vec3& p_DH, const Vec3& per_tick_D) noexcept;
  // J, what the springs hold at the last process().
  double stored() const noexcept { return spring_.stored(record_.depth); }

  double stiffness() const { return spring_.stiffness(); }  // N/m
  double damping() const { return spring_.damping(); }      // N s/m
  double max_force() const { return spring_.max_force(); }  // N
  const WorkspaceWallsRecord& record() const { return record_; }

private:
  Vec3 centre_D_;  // (3) m
  Vec3 border_D_;  // (3) m, half extents of the box about it in which nothing is felt
  DampedSpring spring_;
  WorkspaceWallsRecord record_;
};

}  // namespace fulcrum
