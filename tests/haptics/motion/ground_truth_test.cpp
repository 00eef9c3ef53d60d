// Each response against statics that can be worked out by hand, at the default stiffness or at k per region.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "haptics/math/rotation.h"
#include "tests/haptics/scenes.h"

namespace fulcrum::test {
namespace {

constexpr double kWithin = 0.01;  // of the truth

class GroundTruth : public testing::TestWithParam<ContactResponse> {
protected:
  // A tool in the middle of what is given, carried by springs that are far from saturation.
  SceneDesc scene(const TriangleMesh& walls, const std::vector<Vec3>& points, double k) const {
    SceneDesc desc = floor_scene(points, 0.0);
    desc.scene_field = field_of(walls, 1e-3, 6e-3);
    desc.contact.response = GetParam();
    desc.contact.stiffness = k;
    desc.contact.region_radius = 2e-3;
    desc.integrator = Integrator::implicit_euler;
    desc.coupling.max_force = 1e5;
    desc.coupling.max_torque = 1e4;
    return desc;
  }
  static ContactRegion region_at(const World& world, const Vec3& p_W) {
    ContactRegion nearest;
    double distance = 1e9;
    for (const ContactRegion& region : world.regions()) {
      if ((region.p_W - p_W).norm() >= distance) continue;
      nearest = region;
      distance = (region.p_W - p_W).norm();
    }
    return nearest;
  }
};

// d cos t + L sin t = D: the peg jams at two corners. Under a pure couple tau and springs of k,
//   2 F / k = d cos t + L sin t - D,   tau = F (L cos t - d sin t).
TEST_P(GroundTruth, PegInASlot) {
  const double D = 10.1e-3, d = 10e-3, L = 30e-3, k = 1000;
  const TriangleMesh walls[] = {box_mesh({-0.04, -0.03, -0.02}, {-D / 2, 0.03, 0.02}),
                                box_mesh({D / 2, -0.03, -0.02}, {0.04, 0.03, 0.02})};
  const std::vector<Vec3> corners{
      {d / 2, L / 2, 0}, {-d / 2, L / 2, 0}, {d / 2, -L / 2, 0}, {-d / 2, -L / 2, 0}};
  struct Case {
    double tau, t, F;
  };
  for (const Case& c : {Case{0.001, 0.005564910, 0.033395798}, Case{0.02, 0.048989996, 0.678557185}}) {
    SceneDesc desc = scene(joined(walls), corners, k);
    const bool rigid = GetParam() == ContactResponse::constraint;
    const double t = rigid ? 0.0033351934 : c.t;
    World world = expect(World::build(desc));
    hold(world, {}, 10);
    const StepResult result = hold(
        world, {quaternion_exp(Vec3(0, 0, t + c.tau / desc.coupling.angular_stiffness)), Vec3::Zero()}, 3000);
    const double turned = rotation_vector(result.record.X_WT.q).z();
    EXPECT_NEAR(turned, t, kWithin * t);
    EXPECT_NEAR(result.record.coupling_F_T_W.torque.z(), c.tau, kWithin * c.tau);
    ASSERT_EQ(result.record.regions, 2);
    const double F = rigid ? c.tau / (L * std::cos(t) - d * std::sin(t)) : c.F;
    EXPECT_NEAR(world.regions()[0].force_W.norm(), F, kWithin * F);
    EXPECT_NEAR(world.regions()[1].force_W.norm(), F, kWithin * F);
  }
}

// N = W / (2 sin a) a side.
TEST_P(GroundTruth, BallInAGroove) {
  const double a = 0.6, side = 0.06, W = 4;
  // Two slabs whose faces pass through the origin, leaning by the half angle a from the vertical.
  TriangleMesh slabs[] = {box_mesh({0, -0.02, -0.03}, {0.03, side, 0.03}),
                          box_mesh({-0.03, -0.02, -0.03}, {0, side, 0.03})};
  for (Vec3& p : slabs[0].vertices) p = quaternion_exp(Vec3(0, 0, -a)) * p;
  for (Vec3& p : slabs[1].vertices) p = quaternion_exp(Vec3(0, 0, a)) * p;
  const double r = 5e-3, height = r / std::sin(a);
  // The ball's two deepest points, as the groove sees them.
  const Vec3 right(r * std::cos(a), -r * std::sin(a), 0), left(-right.x(), right.y(), 0);
  SceneDesc desc = scene(joined(slabs), {right, left}, 40000);
  desc.tool.X_WT_start.p = Vec3(0, height + 1e-3, 0);
  World world = expect(World::build(desc));
  hold(world, {Quat::Identity(), Vec3(0, height + 1e-3, 0)}, 10);
  // Pressed down until the coupling carries W.
  const double sink =
      GetParam() == ContactResponse::constraint ? 0.0 : W / (2 * 40000 * std::sin(a) * std::sin(a));
  const Pose X{Quat::Identity(), Vec3(0, height - sink - W / desc.coupling.stiffness, 0)};
  const StepResult result = hold(world, X, 3000);
  EXPECT_NEAR(result.record.contact_F_T_W.force.y(), W, kWithin * W);
  const double N = W / (2 * std::sin(a));
  ASSERT_EQ(result.record.regions, 2);
  EXPECT_NEAR(world.regions()[0].force_W.norm(), N, kWithin * N);
  EXPECT_NEAR(world.regions()[1].force_W.norm(), N, kWithin * N);
}

// A table under a load P at e: W/4 +- P e / (4 a) at each leg, and nothing about how stiff the floor is.
TEST_P(GroundTruth, TableUnderAnEccentricLoad) {
  const double a = 0.02, P = 2.0, e = 4e-3;
  SceneDesc desc = scene(box_mesh({-0.1, -0.04, -0.1}, {0.1, 0, 0.1}),
                         {{a, 0, a}, {a, 0, -a}, {-a, 0, a}, {-a, 0, -a}}, 20000);
  desc.tool.X_WT_start.p = Vec3(0, 1e-3, 0);
  World world = expect(World::build(desc));
  hold(world, {Quat::Identity(), Vec3(0, 1e-3, 0)}, 10);
  // The coupling's wrench is what loads it: a force P and the couple P e about z, at the pose where it rests.
  const bool rigid = GetParam() == ContactResponse::constraint;
  const double sink = rigid ? 0.0 : P / (4 * 20000);
  const double tilt = rigid ? 0.0 : -P * e / (4 * 20000 * a * a);
  const Pose X{quaternion_exp(Vec3(0, 0, tilt - P * e / desc.coupling.angular_stiffness)),
               Vec3(0, -sink - P / desc.coupling.stiffness, 0)};
  const StepResult result = hold(world, X, 3000);
  ASSERT_EQ(result.record.regions, 4);
  EXPECT_NEAR(result.record.contact_F_T_W.force.y(), P, kWithin * P);
  const double mean = P / 4, more = P * e / (4 * a);
  // A rigid table on a rigid floor stands on its legs in more ways than one: only the sides' sums are given.
  double right = 0, left = 0;
  for (const Vec3& leg : {Vec3(a, 0, a), Vec3(a, 0, -a)}) right += region_at(world, leg).force_W.y();
  for (const Vec3& leg : {Vec3(-a, 0, a), Vec3(-a, 0, -a)}) left += region_at(world, leg).force_W.y();
  EXPECT_NEAR(right, 2 * (mean + more), kWithin * 2 * mean);
  EXPECT_NEAR(left, 2 * (mean - more), kWithin * 2 * mean);
}

INSTANTIATE_TEST_SUITE_P(Each, GroundTruth,
                         testing::Values(ContactResponse::penalty, ContactResponse::quasi_static,
                                         ContactResponse::constraint),
                         [](const auto& response) -> std::string {
                           if (response.param == ContactResponse::penalty) return "penalty";
                           return response.param == ContactResponse::quasi_static ? "static" : "constraint";
                         });

}  // namespace
}  // namespace fulcrum::test
