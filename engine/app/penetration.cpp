#include "engine/app/penetration.h"

#include <algorithm>
#include <cmath>

namespace fulcrum::app {
namespace {

constexpr double kEvery = 10e-3;  // s

}  // namespace

PenetrationMeter::PenetrationMeter(double tick_s)
    : every_ticks_(std::max<std::int64_t>(1, std::llround(kEvery / tick_s))) {}

void PenetrationMeter::note(const TickRecord& record) {
  // The record's depth is that of the pose the tick began with; after one tick more or less it is hardly
  // another.
  if (record.depth_max > worst_depth_) {
    worst_depth_ = record.depth_max;
    worst_ = record.X_WT;
  }
  if (record.tick % every_ticks_ != 0) return;
  poses_.push_back(record.X_WT);
  if (worst_) poses_.push_back(*worst_);
  worst_.reset();
  worst_depth_ = 0;
}

double PenetrationMeter::deepest(const Solid& scene_W, const Solid& tool_T,
                                 const DistanceField& field) const {
  const TriangleDistance exact(scene_W);
  double reach = 0;
  for (const Vec3& p_T : tool_T.mesh.vertices) reach = std::max(reach, p_T.norm());
  double deepest = 0;
  const auto measure = [&](const Pose& X_WT) {
    if (field.distance(X_WT.p) > reach + field.error_bound_m()) return;
    const Mat3 R_WT = X_WT.q.toRotationMatrix();
    for (const Vec3& p_T : tool_T.mesh.vertices) {
      const Vec3 p_W = R_WT * p_T + X_WT.p;
      if (field.distance(p_W) - field.local_error_m(p_W) > -deepest) continue;
      deepest = std::max(deepest, -exact.signed_distance(p_W));
    }
  };
  for (const Pose& X_WT : poses_) measure(X_WT);
  if (worst_) measure(*worst_);
  return deepest;
}

}  // namespace fulcrum::app
