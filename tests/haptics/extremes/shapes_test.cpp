// Shapes at the ends of what can be baked, and more contacts than are kept.

#include <gtest/gtest.h>

#include "haptics/bake/pointshell_bake.h"
#include "haptics/math/rotation.h"
#include "tests/haptics/bake/shapes.h"
#include "tests/haptics/extremes/closed_loop.h"

namespace fulcrum::test {
namespace {

// A tool of 20 mm between two plates, 1 um of play: it touches one or the other, never both, and rests.
TEST_P(EveryResponseThatRests, AGapOfAMicrometreComesToRest) {
  const double gap = 1e-6;
  const TriangleMesh plates[] = {box_mesh({-0.05, -0.03, -0.05}, {0.05, -0.01, 0.05}),
                                 box_mesh({-0.05, 0.01 + gap, -0.05}, {0.05, 0.03, 0.05})};
  std::vector<Vec3> points;
  for (const double y : {-0.01, 0.01})
    for (const Vec3& foot : three_feet()) points.emplace_back(foot.x(), y, foot.z());
  for (const Integrator integrator : {Integrator::semi_implicit_euler, Integrator::implicit_euler}) {
    SceneDesc scene = answering(floor_scene(points, gap / 2));
    scene.scene_field = field_of(joined(plates));
    scene.integrator = integrator;
    for (const double push : {0.0, -3e-3, 3e-3}) {
      const Verdict verdict =
          run_closed_loop(scene, hand_from_to(Vec3(0, gap / 2, 0), Vec3(2e-3, push, 0), 0.3), 3);
      EXPECT_TRUE(verdict.at_rest()) << push << ": " << verdict.late_tool << " m, " << verdict.late_force
                                     << " N";
      EXPECT_LT(verdict.depth_max, 1e-3) << push;
      EXPECT_FALSE(verdict.faults & kStoppingFaults) << push;
    }
  }
}

TEST(Extremes, AShellWithoutNormalsIsRefused) {
  const std::vector<Vec3> points{Vec3::Zero()}, normals{Vec3::Zero()};
  const std::vector<double> areas{1e-6};
  const Result<Pointshell> shell = pointshell_from_points(points, normals, areas, 0);
  ASSERT_FALSE(shell);
  EXPECT_NE(shell.error().sentence.find("a normal that is not zero"), std::string::npos);
}

// In the middle of a plate both faces are as near: the field's slope there is none.
TEST_P(EveryResponse, WhereTheFieldHasNoSlopeAPushIsStillOneWay) {
  const auto plate = field_of(box_mesh({-0.05, -0.004, -0.05}, {0.05, 0.004, 0.05}), 1e-3, 6e-3);
  for (const double x : {0.0, 1e-4, 0.01}) {
    const FieldSample sample = plate->sample(Vec3(x, 0, 0));
    EXPECT_NEAR(sample.gradient.norm(), 1, 1e-9) << x;
  }
  SceneDesc scene = answering(floor_scene({Vec3::Zero()}, 0));
  scene.scene_field = plate;
  World world = expect(World::build(scene));
  for (int i = 0; i < 2000; ++i) {
    const StepResult result = step(world, at({Quat::Identity(), Vec3::Zero()}), {});
    ASSERT_TRUE(result.record.X_WT.is_finite() && result.command.F_H_D.is_finite());
    // Without mass the tool is out at once, by as much as a tick's rounds may move it.
    ASSERT_LE(result.record.V_WT.v.norm(), massless(GetParam()) ? 2 : 1);
  }
}

TEST(Extremes, ASheetThinnerThanItsVoxelsIsRefused) {
  const Solid sheet = expect(build_solid(box_mesh({-0.05, 0, -0.05}, {0.05, 1e-4, 0.05})));
  const Result<DistanceField> field = bake_field(sheet, {.voxel_m = 1e-3, .band_m = 6e-3, .threads = 1});
  ASSERT_FALSE(field);
  EXPECT_NE(field.error().sentence.find("0.1 mm thick"), std::string::npos) << field.error().sentence;
  EXPECT_NE(field.error().sentence.find("use a voxel of"), std::string::npos) << field.error().sentence;
}

TEST(Extremes, AnOpenSheetIsRefused) {
  TriangleMesh sheet;
  sheet.vertices = {{0, 0, 0}, {0.1, 0, 0}, {0, 0, 0.1}};
  sheet.triangles = {{0, 1, 2}};
  EXPECT_FALSE(build_solid(sheet));
}

// A needle of 1.27 mm by 100 mm, in fine voxels as the scene and in any as the tool.
TEST_P(EveryResponseThatRests, ANeedleIsFeltFromEitherSide) {
  const TriangleMesh needle = box_mesh({-0.05, -0.000635, -0.000635}, {0.05, 0.000635, 0.000635});
  const Solid solid = expect(build_solid(needle));
  const Result<DistanceField> coarse = bake_field(solid, {.voxel_m = 1e-3, .band_m = 3e-3, .threads = 1});
  ASSERT_FALSE(coarse);
  EXPECT_NE(coarse.error().sentence.find("1.27 mm thick"), std::string::npos) << coarse.error().sentence;

  // As the scene: a handle that is driven across at 1 m/s does not pass.
  SceneDesc scene = answering(floor_scene({Vec3::Zero()}, 0.01));
  scene.scene_field = std::make_shared<DistanceField>(
      expect(bake_field(solid, {.voxel_m = 0.4e-3, .band_m = 3e-3, .threads = 1})));
  World world = expect(World::build(scene));
  hold(world, {Quat::Identity(), Vec3(0, 0.01, 0)}, 600);
  StepResult result;
  for (int i = 0; i < 1000; ++i) {
    const double y = std::max(-0.003, 0.01 - 1e-3 * i);
    result = step(world, at({Quat::Identity(), Vec3(0, y, 0)}), {});
    ASSERT_TRUE(result.record.X_WT.is_finite());
  }
  EXPECT_GT(result.record.X_WT.p.y(), 0) << "on the side from which it came";

  // As the tool: it stands on the floor.
  SceneDesc held = answering(floor_scene({Vec3::Zero()}, 0.004));
  held.integrator = Integrator::implicit_euler;
  held.tool.mass = 1e-3;
  held.tool.inertia_T = Vec3(3e-10, 8e-7, 8e-7).asDiagonal();
  held.tool_shell = std::make_shared<Pointshell>(expect(bake_pointshell(solid, {.spacing_m = 1e-3})));
  const Verdict verdict = run_closed_loop(held, hand_from_to({0, 0.004, 0}, {0, -0.002, 0}, 0.3), 3);
  EXPECT_TRUE(verdict.at_rest()) << verdict.late_tool << " m, " << verdict.late_force << " N";
  EXPECT_LT(verdict.depth_max, 1e-3);
}

// Answers the last tick.
TickRecord press_hundred_thousand_points(Integrator integrator, int ticks) {
  std::vector<Vec3> points;
  for (int i = 0; i < 316; ++i)
    for (int j = 0; j < 317; ++j) points.emplace_back(1e-4 * (i - 158), -0.01, 1e-4 * (j - 158));
  SceneDesc scene = floor_scene(points, 0.0099);  // every point is in the floor, .1 mm deep
  scene.integrator = integrator;
  World world = expect(World::build(scene));
  StepResult result;
  for (int i = 0; i < ticks; ++i) {
    result = step(world, at({Quat::Identity(), Vec3(0, 0.0099, 0)}), {});
    EXPECT_TRUE(result.record.X_WT.is_finite() && result.command.F_H_D.is_finite()) << i;
    EXPECT_LT(result.record.depth_max, 2e-4) << i;
    EXPECT_NEAR(result.record.X_WT.p.y(), 0.01, 2e-4) << i;
    if (i == 0) EXPECT_TRUE(result.record.faults & kContactsReduced);
  }
  return result.record;
}

TEST(Extremes, AHundredThousandContactsAreReducedAndSaidSo) {
  press_hundred_thousand_points(Integrator::implicit_euler, 20);
}

// Which contacts are kept changes from tick to tick, and the tool rocks: by less than a device's counts.
TEST(Extremes, AHundredThousandContactsRockByNothingThatIsFeltLong) {
  for (const Integrator integrator : {Integrator::semi_implicit_euler, Integrator::implicit_euler}) {
    const TickRecord last = press_hundred_thousand_points(integrator, 300);
    EXPECT_TRUE(last.faults & kContactsReduced);
    EXPECT_LT(rotation_vector(last.X_WT.q).norm(), DeviceDesc{}.encoder_step_rad);
    EXPECT_LT(last.V_WT.v.norm(), 1e-3);
  }
}

}  // namespace
}  // namespace fulcrum::test
