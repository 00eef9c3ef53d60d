// A tool that is late, as one that waits until pairs of features are known to it: when it catches up, the
// hand is given back no more than it has put in.

#include <gtest/gtest.h>

#include <algorithm>

#include "haptics/motion/quasi_static_tool.h"

namespace fulcrum {
namespace {

// N, by which a hand is pushed on at most, the way that it goes: the tool waits half the time, and comes back
// to the hand within four ticks.
double pushed_on(VelocityEstimatorKind kind, bool tells_of_it) {
  PlainScene desc;
  desc.velocity.kind = kind;
  desc.device.handle_mass = 0.1;
  QuasiStaticTool tool(desc);
  const Twist V_WG{Vec3(0.3, 0, 0), Vec3::Zero()};
  Pose X_WG = desc.tool.X_WT_start;
  double most = 0;
  for (int i = 0; i < 200; ++i) {
    X_WG.p += desc.tick_s * V_WG.v;
    const int since = i % 20;
    const bool waits = since >= 10, catches_up = i >= 20 && since < 4;
    if (!waits) tool.move((catches_up ? 1.0 / (4 - since) : 1.0) * tool.to_goal(X_WG));
    const Wrench on_tool = tool.settle(X_WG, V_WG, tells_of_it && (waits || catches_up));
    most = std::max(most, -on_tool.force.x());
  }
  return most;
}

TEST(LateTool, PushesNoHandOnAsItCatchesUp) {
  for (const VelocityEstimatorKind kind : {VelocityEstimatorKind::difference, VelocityEstimatorKind::low_pass,
                                           VelocityEstimatorKind::adaptive_window}) {
    EXPECT_LT(pushed_on(kind, true), 1e-9);
    EXPECT_GT(pushed_on(kind, false), 1);
  }
}

}  // namespace
}  // namespace fulcrum
