#include "haptics/bake/resolution.h"

#include "tests/haptics/bake/truth.h"

namespace fulcrum::test {
namespace {

Result<Resolution> choose(const TriangleMesh& mesh, const FieldDesc& desc) {
  const Solid solid = repaired(mesh);
  const TriangleDistance exact(solid);
  return choose_resolution(solid, exact, thinnest_wall(solid, exact, 1), desc);
}

TriangleMesh plate(double thickness) {
  return shapes::box(Vec3(0, 0, 0), Vec3(0.05, thickness, 0.04));
}

TEST(Resolution, ThreeVoxelsFitIntoTheThinnestWallOrItIsRefused) {
  for (const double voxel : {0.51e-3, 0.7e-3, 1e-3}) {
    const auto field = bake_field(repaired(plate(1.5e-3)), {voxel});
    ASSERT_FALSE(field) << voxel;
    EXPECT_NE(
        field.error().sentence.find("is 1.5 mm thick, and needs three voxels across: use a voxel of 0.5 mm"),
        std::string::npos)
        << field.error().sentence;
  }
  const auto field = bake_field(repaired(plate(1.5e-3)), {0.5e-3});
  ASSERT_TRUE(field) << field.error().sentence;
  EXPECT_EQ(field->voxel_reason(), VoxelReason::given);
  EXPECT_EQ(field->band_m(), 1e-3);
}

TEST(Resolution, AThinWallChoosesTheVoxel) {
  const auto field = bake_field(repaired(plate(0.8e-3)), {});
  ASSERT_TRUE(field) << field.error().sentence;
  EXPECT_NEAR(field->voxel_m(), 0.26e-3, 1e-12);
  EXPECT_EQ(field->voxel_reason(), VoxelReason::thinnest_wall);
  EXPECT_NEAR(field->thinnest_feature_m(), 0.8e-3, 1e-9);
  EXPECT_NEAR(field->distance(Vec3(0.0251, 0.4e-3, 0.0202)), -0.4e-3, 0.1e-3);
}

// Of a ball the error is h^2/(4 R) everywhere; the voxel follows its root, and the field keeps what was
// asked.
TEST(Resolution, TheWantedErrorChoosesTheVoxelAndIsKept) {
  const double R = 0.001;
  const Solid ball = repaired(shapes::sphere(Vec3(0.001, 0.002, 0.003), R, 100));
  const TriangleDistance exact(ball);
  double before = 0.0;
  for (const double error : {5e-5, 1.25e-5}) {
    FieldDesc desc;
    desc.error_m = error;
    const auto field = bake_field(ball, desc);
    ASSERT_TRUE(field) << field.error().sentence;
    EXPECT_EQ(field->voxel_reason(), VoxelReason::error);
    EXPECT_LE(field->contact_error_m(), error);
    std::size_t kept = 0;
    for (const Vec3& p : ball.mesh.vertices) kept += std::abs(field->distance(p)) <= 1.05 * error ? 1 : 0;
    EXPECT_GE(static_cast<double>(kept), 0.93 * static_cast<double>(ball.mesh.vertices.size()));
    EXPECT_GT(field->voxel_m(), 0.7 * std::sqrt(4.0 * R * error));  // no finer than it has to be
    if (before > 0.0) EXPECT_NEAR(field->voxel_m() / before, 0.5, 0.12);
    before = field->voxel_m();
  }
}

TEST(Resolution, TheGivenBandHoldsTwoVoxels) {
  const auto chosen = choose(shapes::box(Vec3::Zero(), Vec3::Constant(0.05)), {.band_m = 0.8e-3});
  ASSERT_TRUE(chosen) << chosen.error().sentence;
  EXPECT_NEAR(chosen->voxel_m, 0.4e-3, 1e-12);
  EXPECT_EQ(chosen->reason, VoxelReason::band);
}

TEST(Resolution, MemoryBoundsTheVoxelButNotAWall) {
  const auto chosen = choose(shapes::box(Vec3::Zero(), Vec3::Constant(6.0)), {.error_m = 1e-6});
  ASSERT_TRUE(chosen) << chosen.error().sentence;
  EXPECT_EQ(chosen->reason, VoxelReason::memory);
  EXPECT_GT(chosen->voxel_m, 2e-3);

  const auto refused = choose(shapes::box(Vec3::Zero(), Vec3(6.0, 2e-3, 6.0)), {});
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().sentence.find("three voxels across it would make a field of about"),
            std::string::npos)
      << refused.error().sentence;
}

TEST(Resolution, TheEstimateOfMemoryIsOne) {
  const auto field = bake_field(repaired(shapes::box(Vec3::Zero(), Vec3::Constant(0.1))), {1e-3});
  ASSERT_TRUE(field);
  EXPECT_NEAR(static_cast<double>(field->bytes()) / (2.0 * 19.0 * 0.06 / 1e-6), 1.0, 0.35);
}

TEST(Resolution, NonsenseIsRefused) {
  FieldDesc desc;
  for (const double error : {0.0, -1.0, std::nan("")}) {
    desc.error_m = error;
    EXPECT_FALSE(choose(plate(0.01), desc));
  }
  EXPECT_FALSE(choose(plate(0.01), {.band_m = -1.0}));
  EXPECT_FALSE(choose(plate(0.01), {.band_m = 1e-7}));
}

}  // namespace
}  // namespace fulcrum::test
