#include "haptics/effects/workspace_walls/workspace_walls.h"

#include <algorithm>
#include <cmath>

#include "haptics/device/linear_loop.h"
#include "haptics/math/bisect.h"
#include "haptics/math/functions.h"

namespace fulcrum {
namespace {

constexpr double kLimitShare = 0.25;                // of the limit, where no stiffness is given
constexpr double kMarginShare = 0.2;                // of the workspace's smallest half extent
constexpr double kSoftest = 1e-3, kStiffest = 1e9;  // N/m, where the search begins and ends
constexpr double kPrecision = 1e-4;                 // of the limit
constexpr double kMostDelay = 8;                    // ticks

double damping_for(double K, const DeviceDesc& device) {
  return 2 * WorkspaceWalls::kDampingRatio * std::sqrt(K * device.handle_mass);
}

double pole_of(double tick_s) {
  return math::exp(-tick_s / WorkspaceWalls::kSmoothing);
}

// A device with a rate of its own is as late as its samples may be old.
int delay_of(const DeviceDesc& device, double tick_s) {
  if (device.sample_rate_Hz <= 0) return 0;
  return static_cast<int>(std::min(kMostDelay, std::ceil(1 / (device.sample_rate_Hz * tick_s))));
}

double suited_stiffness(const DeviceDesc& device, double tick_s, double largest) {
  double K = std::min(largest, kLimitShare * WorkspaceWalls::stiffness_limit(device, tick_s));
  if (device.friction > 0 && device.encoder_step > 0)
    K = std::min(K, 2 * device.friction / device.encoder_step);
  return K;
}

}  // namespace

double WorkspaceWalls::stiffness_limit(const DeviceDesc& device, double tick_s) {
  const WallLoop loop{.axis = {.mass = device.handle_mass, .damping = device.damping},
                      .tick_s = tick_s,
                      .delay_ticks = delay_of(device, tick_s),
                      .filter_pole = pole_of(tick_s)};
  return end_above(kSoftest, kPrecision, [&](double K) {
    return K < kStiffest && exact_growth(loop, {.K = K, .B = damping_for(K, device)}) < 0;
  });
}

double WorkspaceWalls::margin(const WorkspaceWallsDesc& desc, const DeviceDesc& device) {
  return desc.margin.value_or(kMarginShare * device.workspace.minCoeff());
}

WorkspaceWalls::WorkspaceWalls(const WorkspaceWallsDesc& desc, const DeviceDesc& device, double tick_s)
    : centre_D_(device.workspace_centre),
      border_D_(device.workspace.array() - margin(desc, device)),
      max_force_(kForceShare * device.max_force),
      stiffness_(desc.stiffness ? *desc.stiffness
                                : suited_stiffness(device, tick_s, max_force_ / margin(desc, device))),
      damping_(damping_for(stiffness_, device)),
      pole_(pole_of(tick_s)),
      tick_s_(tick_s) {}

Vec3 WorkspaceWalls::process(const Vec3& p_DH, const Vec3& per_tick_D) noexcept {
  velocity_D_ = pole_ * velocity_D_ + (1 - pole_) / tick_s_ * per_tick_D;
  record_ = {};
  const Vec3 p_D = p_DH - centre_D_;
  const Vec3 outside_D = p_D - p_D.cwiseMax(-border_D_).cwiseMin(border_D_);
  if (outside_D.isZero(0)) return record_.force_D;
  record_.depth = outside_D.norm();
  const Vec3 dhat_D = outside_D / record_.depth;
  const double push = stiffness_ * record_.depth + damping_ * velocity_D_.dot(dhat_D);
  record_.force_D = -std::clamp(push, 0.0, max_force_) * dhat_D;
  return record_.force_D;
}

double WorkspaceWalls::stored() const noexcept {
  const double whole = max_force_ / stiffness_;  // m, from where on the force grows no more
  const double bent = std::min(record_.depth, whole);
  return stiffness_ * bent * bent / 2 + max_force_ * (record_.depth - bent);
}

}  // namespace fulcrum
