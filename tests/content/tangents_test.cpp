// Tangents of relief, of squares whose pictures lie as they do.

#include "tools/content/mesh/tangents.h"

#include <gtest/gtest.h>

namespace fulcrum::content {
namespace {

// A square in the plane of x and y, seen from +z, on which a picture lies: `turn` has its u and v in columns
// x and y.
std::vector<Eigen::Vector4f> of_square(const Eigen::Matrix2f& turn) {
  ShadedMesh mesh;
  std::vector<Eigen::Vector2f> uv;
  for (const Eigen::Vector2f& p : {Eigen::Vector2f{0, 0}, {1, 0}, {1, 1}, Eigen::Vector2f{0, 1}}) {
    mesh.positions.emplace_back(p.x(), p.y(), 0.0F);
    mesh.normals.emplace_back(0.0F, 0.0F, 1.0F);
    uv.emplace_back(turn * p);
  }
  mesh.indices = {0, 1, 2, 0, 2, 3};
  return tangents(mesh, uv);
}

void expect_all(const std::vector<Eigen::Vector4f>& found, const Eigen::Vector4f& expected) {
  ASSERT_EQ(found.size(), 4u);
  for (const Eigen::Vector4f& each : found) EXPECT_LT((each - expected).norm(), 1e-6F) << each.transpose();
}

// A picture's v grows downwards.
TEST(Tangents, RunAlongUWhereverAPictureIsTurned) {
  Eigen::Matrix2f upright, turned, mirrored;
  upright << 2, 0, 0, -2;
  turned << 0, 3, 3, 0;
  mirrored << -1, 0, 0, -1;
  expect_all(of_square(upright), {1, 0, 0, 1});
  expect_all(of_square(turned), {0, 1, 0, 1});
  expect_all(of_square(mirrored), {-1, 0, 0, -1});
}

TEST(Tangents, OfAPictureThatIsDrawnOutToALineAreUnitAndSquareToTheNormal) {
  for (const Eigen::Vector4f& each : of_square(Eigen::Matrix2f::Zero())) {
    EXPECT_NEAR(each.head<3>().norm(), 1.0F, 1e-6F);
    EXPECT_NEAR(each.z(), 0.0F, 1e-6F);
  }
}

}  // namespace
}  // namespace fulcrum::content
