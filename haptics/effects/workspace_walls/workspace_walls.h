#pragma once
// The border of the workspace is felt before an arm comes to its hard stops: a box in D, a margin inside
// the device's half extents about its workspace's centre, that pushes a handle outside of it back towards
// its nearest point. With d (3) m from that point to the handle, dhat its direction and v the handle's
// velocity:
//     f = -clamp(K |d| + B v . dhat, 0, f_max) dhat
// K |d|, no larger than f_max, is the slope of a potential in |d|, so that without the damper a closed way
// costs nothing and gives nothing; the damper only takes, and the walls never pull.
//
// K and B are at the device, whatever the mapping is. Where K is not given it is the smallest of
//     a quarter of the limit    up to which a handle in no hand stays stable against it: the exact loop of
//                               device/linear_loop.h. A coupling takes half of its own limit at most;
//     2 f_c / D                 what friction holds still from one encoder count to the next (Diolaiti et
//                               al., IEEE Trans. Robotics 22(2), 2006), where there are both;
//     f_max / margin            with which the force is whole at the workspace's end.
// B = 2 zeta sqrt(K m) of the bare handle m. The velocity is that of the encoders through a first-order
// low-pass, as the loop's WallLoop::filter_pole has it. A jump of the handle, by a device's error or over
// samples that were lost, is no velocity (estimate/encoder_motion.h): the spring alone answers it, and no
// faster than the slew limit.

#include <optional>

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
  static constexpr double kForceShare = 0.5;    // of the device's largest force: the rest is the scene's
  static constexpr double kMostShare = 0.5;     // of stiffness_limit(): a coupling takes as much of its own
  static constexpr double kDampingRatio = 0.5;  // zeta
  static constexpr double kSmoothing = 2e-3;    // s, time constant of the low-pass

  // N/m, the stiffest that this device, let go, holds at this tick.
  static double stiffness_limit(const DeviceDesc& device, double tick_s);
  static double margin(const WorkspaceWallsDesc& desc, const DeviceDesc& device);  // m

  WorkspaceWalls(const WorkspaceWallsDesc& desc, const DeviceDesc& device, double tick_s);

  // p_DH (3) m; per_tick_D (3) m per tick, the handle's motion. Returns the force on the handle (3) N, in D.
  Vec3 process(const Vec3& p_DH, const Vec3& per_tick_D) noexcept;
  // J, what the springs hold at the last process().
  double stored() const noexcept;

  double stiffness() const { return stiffness_; }  // N/m
  double damping() const { return damping_; }      // N s/m
  double max_force() const { return max_force_; }  // N
  const WorkspaceWallsRecord& record() const { return record_; }

private:
  Vec3 centre_D_;  // (3) m
  Vec3 border_D_;  // (3) m, half extents of the box about it in which nothing is felt
  double max_force_, stiffness_, damping_;
  double pole_;  // of the low-pass, 0 to 1
  double tick_s_;
  Vec3 velocity_D_ = Vec3::Zero();  // (3) m/s, through the low-pass
  WorkspaceWallsRecord record_;
};

}  // namespace fulcrum
