// Tools without mass against analytic truths: what the hand feels is the coupling's offset, and the offset is
// known.

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "haptics/math/rotation.h"
#include "tests/haptics/scenes.h"

namespace fulcrum::test {
namespace {

Pose above_floor(double y) {
  return {Quat::Identity(), Vec3(0, y, 0)};
}

SceneDesc scene(ContactResponse response, const std::vector<Vec3>& points) {
  SceneDesc desc = floor_scene(points, 0.02);
  desc.contact.response = response;
  desc.mapping.force_scale = 1;
  return desc;
}

// Far below its saturation, so that it is linear to a thousandth.
CouplingDesc linear_coupling() {
  CouplingDesc coupling;
  coupling.max_force = 5000;
  coupling.max_torque = 500;
  return coupling;
}

StepResult held(World& world, const Pose& X_WH) {
  return hold(world, X_WH, 800);
}

TEST(Constraint, AProbeStopsAtTheSurfaceAndFeelsTheCoupling) {
  SceneDesc desc = scene(ContactResponse::constraint, {Vec3::Zero()});
  desc.coupling = linear_coupling();
  World world = expect(World::build(desc));
  held(world, above_floor(0.02));
  const StepResult result = held(world, above_floor(-5e-3));
  EXPECT_NEAR(result.record.X_WT.p.y(), 0, 2e-6);
  EXPECT_NEAR(result.record.contact_F_T_W.force.y(), 800 * 5e-3, 0.01 * 4);
  EXPECT_EQ(result.record.regions, 1);
  EXPECT_LT(result.record.depth_max, 2e-6);
}

TEST(Constraint, FreeOfContactTheToolIsWhereTheHandIs) {
  SceneDesc desc = scene(ContactResponse::constraint, {Vec3::Zero()});
  World world = expect(World::build(desc));
  const Pose X{quaternion_exp(Vec3(0.3, -0.2, 0.1)), Vec3(0.01, 0.05, -0.02)};
  const StepResult result = held(world, X);
  EXPECT_LT((result.record.X_WT.p - X.p).norm(), 1e-9);
  EXPECT_LT(rotation_vector(result.record.X_WT.q * X.q.conjugate()).norm(), 1e-9);
  EXPECT_LT(result.record.coupling_F_T_W.force.norm(), 1e-5);
}

TEST(Constraint, TheHandCarriesTheWeightAndNothingElse) {
  for (const ContactResponse response : {ContactResponse::constraint, ContactResponse::quasi_static}) {
    SceneDesc desc = scene(response, {Vec3::Zero()});
    desc.tool.weight = true;
    World world = expect(World::build(desc));
    EXPECT_NEAR(held(world, above_floor(0.05)).record.coupling_F_T_W.force.y(), 0.2 * 9.80665, 1e-6);
  }
}

// Pushed into the surface and slid along it: no friction, so only the pushing is felt.
TEST(Constraint, SlidesAlongASurface) {
  SceneDesc desc = scene(ContactResponse::constraint, {Vec3::Zero()});
  desc.coupling = linear_coupling();
  World world = expect(World::build(desc));
  held(world, above_floor(-3e-3));
  StepResult result;
  for (int i = 0; i < 200; ++i) result = step(world, at({Quat::Identity(), Vec3(2e-4 * i, -3e-3, 0)}), {});
  EXPECT_NEAR(result.record.X_WT.p.x(), 2e-4 * 199, 1e-4);
  EXPECT_NEAR(result.record.X_WT.p.y(), 0, 2e-6);
  EXPECT_NEAR(result.record.contact_F_T_W.force.x(), 0, 1e-3);
}

std::vector<std::uint32_t> ids_of(const World& world) {
  std::vector<std::uint32_t> ids;
  for (const ContactRegion& region : world.regions()) ids.push_back(region.id);
  std::sort(ids.begin(), ids.end());
  return ids;
}

// Impacts will be told from it: sliding is no new touch, coming back is.
TEST(Constraint, RegionsKeepTheirIdentityUntilTheToolLeaves) {
  World world =
      expect(World::build(scene(ContactResponse::constraint,
                                {Vec3(0.02, -0.01, 0.02), Vec3(-0.02, -0.01, 0.02), Vec3(0, -0.01, -0.02)})));
  hold(world, above_floor(0.02), 600);
  hold(world, above_floor(0.008), 10);
  const std::vector<std::uint32_t> first = ids_of(world);
  ASSERT_EQ(first.size(), 3u);
  for (int i = 1; i <= 300; ++i) {
    const Pose X_WH{quaternion_exp(Vec3(0, 1e-3 * i, 0)), Vec3(1e-4 * i, 0.008, 5e-5 * i)};
    step(world, at(X_WH), {});
    ASSERT_EQ(ids_of(world), first) << i;
    for (const ContactRegion& region : world.regions()) ASSERT_GE(region.age_ticks, i);
  }
  hold(world, above_floor(0.02), 10);
  ASSERT_TRUE(world.regions().empty());
  hold(world, above_floor(0.008), 10);
  ASSERT_EQ(world.regions().size(), 3u);
  for (const ContactRegion& region : world.regions()) EXPECT_GT(region.id, first.back());
}

// A box pressed askew onto the floor: nearest pose in the metric, from the hand-made minimum. Four corners at
// +-a; the handle a depth below the floor and turned by a small angle about z. If two corners touch,
//   minimise k_T y^2 / 2 + k_R t^2 / 2,   y, t the tool's offsets from the handle, subject to
//   -depth + y - a sin(theta - t) = 0 at the lower edge.
TEST(Constraint, NearestPoseIsInTheMetricOfTheCoupling) {
  const double a = 0.02, depth = 2e-3, angle = 0.04;
  SceneDesc desc = scene(ContactResponse::constraint, {{a, 0, a}, {a, 0, -a}, {-a, 0, a}, {-a, 0, -a}});
  desc.coupling = linear_coupling();
  World world = expect(World::build(desc));
  held(world, above_floor(0.02));
  const StepResult result = held(world, {quaternion_exp(Vec3(0, 0, angle)), Vec3(0, -depth, 0)});
  // Both edges of the lower side touch if the torque of the lower one alone would turn it flat: with
  // stationarity k_T y = f, k_R t = f a cos, the lower edge alone needs t = y k_T a / k_R.
  const double k_T = desc.coupling.stiffness, k_R = desc.coupling.angular_stiffness;
  const double alone = (depth + a * angle) / (1 + k_T * a * a / k_R);  // y, small angles
  ASSERT_LT(k_T * a / k_R * alone, angle) << "one edge was to touch";
  EXPECT_NEAR(result.record.X_WT.p.y(), -depth + alone, 0.01 * alone);
  EXPECT_NEAR(result.record.contact_F_T_W.force.y(), k_T * alone, 0.01 * k_T * alone);
  EXPECT_NEAR(std::abs(result.record.contact_F_T_W.torque.z()), k_T * alone * a, 0.01 * k_T * alone * a);
}

TEST(Constraint, ToolThatStartsShallowInsideIsPutOut) {
  SceneDesc desc = scene(ContactResponse::constraint, {Vec3::Zero()});
  desc.tool.X_WT_start.p.y() = -4e-3;
  World world = expect(World::build(desc));
  const StepResult result = held(world, above_floor(-4e-3));
  EXPECT_EQ(result.record.faults & kStoppingFaults, 0u);
  EXPECT_NEAR(result.record.X_WT.p.y(), 0, 2e-6);
}

TEST(Constraint, NoHandleSpeedTakesTheToolThroughTheFloor) {
  SceneDesc desc = scene(ContactResponse::constraint, {{0.02, -0.01, 0}, {-0.02, -0.01, 0}, {0, 0.01, 0.02}});
  World world = expect(World::build(desc));
  double deepest = 0;
  for (int i = 0; i < 20000; ++i) {
    const double jump = i % 7 == 0 ? 0.5 : -0.5;
    const StepResult result = step(world, at({quaternion_exp(Vec3(0, 0, 0.3 * i)), Vec3(0, jump, 0)}), {});
    deepest = std::max(deepest, result.record.depth_max);
    ASSERT_TRUE(result.record.X_WT.is_finite());
  }
  EXPECT_LT(deepest, 0.3 * 2e-3) << "three tenths of a voxel";
}

// A slot a tenth of a millimetre narrower than the tool: no room, no runaway.
TEST(Constraint, AJammedToolStandsStill) {
  const TriangleMesh walls[] = {box_mesh({-0.05, -0.02, -0.05}, {-0.01, 0.02, 0.05}),
                                box_mesh({0.01, -0.02, -0.05}, {0.05, 0.02, 0.05})};
  SceneDesc desc = scene(ContactResponse::constraint, {{0.01005, 0, 0}, {-0.01005, 0, 0}});
  desc.scene_field = field_of(joined(walls), 1e-3, 6e-3);
  desc.tool.X_WT_start.p = Vec3::Zero();
  World world = expect(World::build(desc));
  held(world, {Quat::Identity(), Vec3::Zero()});
  const Pose before = held(world, {Quat::Identity(), Vec3(3e-3, 0, 0)}).record.X_WT;
  const StepResult after = held(world, {Quat::Identity(), Vec3(3e-3, 0, 0)});
  EXPECT_LT((after.record.X_WT.p - before.p).norm(), 1e-7);
  EXPECT_NEAR(after.record.X_WT.p.x(), 0, 1e-5) << "both walls are broken alike";
  EXPECT_NEAR(after.record.depth_max, 5e-5, 1e-5);
}

// Two springs in series, by Newton's method.
TEST(Static, CouplingAndSurfaceAreSpringsInSeries) {
  SceneDesc desc = scene(ContactResponse::quasi_static, {Vec3::Zero()});
  desc.coupling = linear_coupling();
  desc.contact.stiffness = 4000;
  World world = expect(World::build(desc));
  held(world, above_floor(0.02));
  const double x = 3e-3, k_c = 800, k = 4000;
  const StepResult result = held(world, above_floor(-x));
  EXPECT_NEAR(result.record.contact_F_T_W.force.y(), k_c * k * x / (k_c + k), 0.01 * k_c * x);
  EXPECT_NEAR(result.record.depth_max, k_c * x / (k_c + k), 0.01 * x);
}

TEST(Static, AnyContactStiffnessSettles) {
  for (const double k : {1e-1, 1e2, 1e5, 1e8}) {
    SceneDesc desc = scene(ContactResponse::quasi_static, {{0.02, 0, 0}, {-0.02, 0, 0}, {0, 0, 0.02}});
    desc.contact.stiffness = k;
    World world = expect(World::build(desc));
    held(world, above_floor(0.01));
    const Pose before = held(world, above_floor(-4e-3)).record.X_WT;
    const Pose after = hold(world, above_floor(-4e-3), 1).record.X_WT;
    // Distances are of single precision; at 1e8 N/m a few newtons are a depth of no more than that.
    EXPECT_LT((after.p - before.p).norm(), 1e-6) << k;
  }
}

}  // namespace
}  // namespace fulcrum::test
