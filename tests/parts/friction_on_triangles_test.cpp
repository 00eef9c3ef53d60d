// Coulomb friction of a constraint on triangles, against what statics says of a block on a floor and on a
// slope, of a disc that is spun and of a sleeve that is pulled askew along a rod.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "haptics/bake/solid.h"
#include "haptics/math/rotation.h"
#include "haptics/world/world.h"
#include "tests/parts/content_mesh.h"
#include "tests/parts/flat.h"
#include "tests/parts/in_hand.h"
#include "tools/content/mesh/metric_thread.h"

namespace fulcrum::parts {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kStiffness = 800;  // N/m

// A tool on a scene, in a hand that pulls by springs alone, far below where they saturate.
SceneDesc rubbing(const TriangleMesh& tool_T, const TriangleMesh& scene_W, double friction,
                  double angular_stiffness) {
  SceneDesc desc = in_hand(tool_T, scene_W);
  desc.contact.friction = friction;
  desc.coupling = {.stiffness = kStiffness,
                   .angular_stiffness = angular_stiffness,
                   .damping_ratio = 0,
                   .max_force = 5000,
                   .max_torque = 500};
  return desc;
}

TriangleMesh block(const Vec2& size, double low, double high) {
  std::vector<Vec2> corners = circle(1, 4, kPi / 4);
  for (Vec2& p : corners) p = p.cwiseQuotient(p.cwiseAbs()).cwiseProduct(size / 2);
  return extruded(star(corners), low, high);
}

TriangleMesh floor() {
  return block({0.4, 0.4}, -0.02, 0);
}

// Pressed down and dragged along: it sticks up to the cone, and then lags behind the hand by just that.
TEST(FrictionOnTriangles, HoldsABlockUpToItsCone) {
  for (const double coefficient : {0.1, 0.5, 1.0}) {
    SceneDesc desc = rubbing(block({0.02, 0.02}, 0, 0.01), floor(), coefficient, 50);
    Result<World> world = World::build(desc);
    ASSERT_TRUE(world) << world.error().sentence;
    const double depth = 2e-3, cone = coefficient * depth;  // m of the coupling's offset
    TickRecord record;
    for (int i = 0; i < 100; ++i) record = tick(*world, desc, {Quat::Identity(), {0, 0, -depth}}).record;
    const Vec3 begin = record.X_WT.p;
    for (int i = 0; i < 400; ++i)
      record =
          tick(*world, desc, {Quat::Identity(), {std::min(1.0, i / 100.0) * 0.9 * cone, 0, -depth}}).record;
    EXPECT_LT((record.X_WT.p - begin).norm(), 1e-6) << coefficient;
    for (int i = 0; i < 600; ++i)
      record = tick(*world, desc, {Quat::Identity(), {0.9 * cone + 1e-2 * cone * i, 1e-2 * cone * i, -depth}})
                   .record;
    const Vec3 lag = Vec3((0.9 + 5.99) * cone, 5.99 * cone, 0) - record.X_WT.p;
    EXPECT_NEAR(std::hypot(lag.x(), lag.y()), cone, 0.02 * cone) << coefficient;
    EXPECT_NEAR(record.contact_F_T_W.force.z(), kStiffness * depth, 0.01 * kStiffness * depth);
    EXPECT_LT(record.depth_max, 1e-6);
  }
}

// Pulled straight down onto a slope: below atan(mu) it stays, and above it slides until what pulls it along
// is within the cone of what presses it on.
TEST(FrictionOnTriangles, HoldsABlockOnASlopeUpToItsAngle) {
  constexpr double coefficient = 0.3, depth = 3e-3;
  for (const double degrees : {5.0, 15.0, 16.0, 17.5, 25.0}) {
    const double angle = degrees * kPi / 180;
    const Quat tilt = quaternion_exp(Vec3(0, angle, 0));
    SceneDesc desc =
        rubbing(block({0.02, 0.02}, 0, 0.01), moved(floor(), Eigen::Isometry3d(tilt)), coefficient, 50);
    desc.tool.X_WT_start = {tilt, tilt * Vec3(0, 0, 1e-6)};
    Result<World> world = World::build(desc);
    ASSERT_TRUE(world) << world.error().sentence;
    TickRecord record;
    for (int i = 0; i < 600; ++i)
      record = tick(*world, desc, {tilt, Vec3(0, 0, -depth * std::min(1.0, i / 200.0))}).record;
    const double slid = (tilt.conjugate() * record.X_WT.p).x();
    const double truth = depth * std::max(0.0, std::sin(angle) - coefficient * std::cos(angle));
    EXPECT_NEAR(slid, truth, 2e-6 + 0.01 * truth) << degrees;
  }
}

// It touches with its rim, whose corners are at R: more torque than friction has there turns it.
TEST(FrictionOnTriangles, HoldsADiscUpToItsTorque) {
  constexpr double R = 0.01, depth = 2e-3, coefficient = 0.3, k_R = 2;
  SceneDesc desc = rubbing(extruded(star(circle(R, 24)), 0, 0.004), floor(), coefficient, k_R);
  Result<World> world = World::build(desc);
  ASSERT_TRUE(world) << world.error().sentence;
  constexpr double most = coefficient * kStiffness * depth * R;
  TickRecord record;
  for (int i = 0; i < 100; ++i) record = tick(*world, desc, {Quat::Identity(), {0, 0, -depth}}).record;
  for (int i = 1; i <= 300; ++i) {
    const double angle = 2 * most / k_R * i / 300;
    record = tick(*world, desc, {quaternion_exp(Vec3(0, 0, angle)), {0, 0, -depth}}).record;
    ASSERT_NEAR(record.coupling_F_T_W.torque.z(), std::min(most, k_R * angle), 0.01 * most) << i;
  }
}

// A load beside a rod tips the sleeve, which presses with two edges that are L apart: what both can hold is
// 2 mu M / L, however large the load is. Where that is more than the load the sleeve jams.
TEST(FrictionOnTriangles, ASleeveJamsWhereItsLoadIsFarOff) {
  constexpr double L = 0.02, width = 0.008, coefficient = 0.3, k_R = 50, gap = 10e-6, load = 2;
  const auto outline = [](double across) {
    std::vector<Vec2> corners = circle(1, 4, kPi / 4);
    for (Vec2& p : corners) p *= across / 2 / p.cwiseAbs().maxCoeff();
    return corners;
  };
  for (const double torque : {0.03, 0.06, 0.09, 0.15}) {
    SceneDesc desc = rubbing(extruded(ring(outline(width + 2 * gap), outline(3 * width)), -L / 2, L / 2),
                             extruded(star(outline(width)), -0.2, 0.2), coefficient, k_R);
    Result<World> world = World::build(desc);
    ASSERT_TRUE(world) << world.error().sentence;
    TickRecord record;
    for (int i = 0; i < 1000; ++i) {  // tipped first, and then pulled
      const double tipped = std::min(1.0, i / 100.0), pulled = std::clamp((i - 200) / 200.0, 0.0, 1.0);
      const Pose goal{quaternion_exp(Vec3(0, tipped * torque / k_R, 0)), {0, 0, -pulled * load / kStiffness}};
      record = tick(*world, desc, goal).record;
    }
    const double M = std::abs(record.coupling_F_T_W.torque.y()), F = -record.coupling_F_T_W.force.z();
    EXPECT_NEAR(F, std::min(load, 2 * coefficient * M / L), 0.02 * load) << torque;
  }
}

// A nut that a load presses along a screw of six threads, turned at an even pace with the load and against
// it. Without friction the hand's torque is the load times lead / 2 pi. With friction it is more against the
// load, and less with it: from tan(lead angle) cos(flank angle) on the nut has to be driven down, and holds
// its place by itself. Where on the flanks it rubs, between the nut's root and the screw's crest, is not
// known. The mean over turns by whole facets is free of what their corners do.
TEST(FrictionOnTriangles, ANutHoldsItsPlaceUpToItsLead) {
  constexpr content::MetricThread thread{.diameter = 12e-3, .pitch = 1.75e-3, .starts = 6};
  constexpr double height = 8e-3, load = 2, k_R = 5;
  constexpr int facets = 48, ticks_a_facet = 100, settling = 100;
  const TriangleMesh screw =
                         mesh_of(content::threaded_rod(thread, 20e-3, content::LeadIn::chamfered, facets)),
                     nut = mesh_of(
                         content::threaded_nut(thread, height, 18e-3, content::LeadIn::chamfered, facets));
  const double outer = thread.diameter / 2, inner = outer - 5.0 / 8 * std::sqrt(3.0) / 2 * thread.pitch;
  // sign: 1 against the load, -1 with it.
  const auto torque = [&](double r, double friction, double sign) {
    const double lead_angle = std::atan2(thread.lead(), 2 * kPi * r);
    const double flank = std::atan(std::tan(kPi / 6) * std::cos(lead_angle));
    return load * r * std::tan(lead_angle + sign * std::atan(friction / std::cos(flank)));
  };
  struct Turn {
    double friction, sign;
  };
  for (const auto& [friction, sign] :
       {Turn{0, 1}, Turn{0, -1}, Turn{0.15, 1}, Turn{0.15, -1}, Turn{0.35, -1}, Turn{0.5, -1}}) {
    SceneDesc desc = rubbing(nut, screw, friction, k_R);
    desc.tool.X_WT_start.p.z() = 4 * thread.pitch;
    Result<World> world = World::build(desc);
    ASSERT_TRUE(world) << world.error().sentence;
    TickRecord record;
    record.X_WT = desc.tool.X_WT_start;
    double mean = 0;
    for (int i = 0; i < settling + 2 * ticks_a_facet; ++i) {
      // The hand goes with the nut, so that the load stays what it is.
      const double pulled = std::min(1.0, i / 30.0) * load / kStiffness;
      const double angle = sign * 2 * kPi / facets * i / ticks_a_facet;
      const Vec3 goal(record.X_WT.p - Vec3(0, 0, pulled));
      record = tick(*world, desc, {quaternion_exp(Vec3(0, 0, angle)), goal}).record;
      if (i >= settling) mean += record.coupling_F_T_W.torque.z() / (2 * ticks_a_facet);
      ASSERT_LT(record.depth_max, 1e-6);
    }
    const double rounding = friction > 0 ? 0 : 0.01 * load * thread.lead() / (2 * kPi);
    const auto [least, most] = std::minmax({torque(inner, friction, sign), torque(outer, friction, sign)});
    EXPECT_GT(mean, least - rounding) << friction << ' ' << sign;
    EXPECT_LT(mean, most + rounding) << friction << ' ' << sign;
    const bool is_driven = mean<0, should_be = friction> 0.3;
    EXPECT_EQ(is_driven, should_be) << friction << ": a nut that holds its place has to be driven down";
  }
}

}  // namespace
}  // namespace fulcrum::parts
