// Parts as meshes: closed, free where they are in place and on their way, and held where they are to be.

#include "tests/parts/fits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <utility>

#include "haptics/math/rotation.h"
#include "tests/parts/exact_depth.h"
#include "tools/content/mesh/metric_thread.h"

namespace fulcrum::parts {
namespace {

constexpr double kFitSpacing = 0.4e-3;

bool is_closed(const TriangleMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const Triangle& t : mesh.triangles)
    for (std::size_t e = 0; e < 3; ++e) ++edges[{t[e], t[(e + 1) % 3]}];
  return std::ranges::all_of(edges, [&](const auto& edge) {
    return edge.second == 1 && edges.contains({edge.first.second, edge.first.first});
  });
}

double volume(const TriangleMesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles)
    sum += mesh.vertices[t[0]].dot(mesh.vertices[t[1]].cross(mesh.vertices[t[2]])) / 6;
  return sum;
}

Pose turned(const Fit& fit, double angle, double rise) {
  return {quaternion_exp(angle * fit.way_W) * fit.X_WT.q, fit.X_WT.p + rise * fit.way_W};
}

TEST(Fits, AreClosedAndFreeInPlace) {
  for (const Fit& fit : fits()) {
    for (const TriangleMesh* mesh : {&fit.tool_T, &fit.scene_W}) {
      EXPECT_TRUE(is_closed(*mesh)) << fit.name;
      EXPECT_GT(volume(*mesh), 0) << fit.name;
    }
    EXPECT_GT(fit.clearance, 0) << fit.name;
    EXPECT_EQ(ExactDepth(fit.tool_T, fit.scene_W, kFitSpacing).at(fit.X_WT), 0) << fit.name;
  }
}

TEST(Fits, PegsAreHeldByTheirHoles) {
  for (const Fit& fit : fits()) {
    if (!fit.name.starts_with("square peg")) continue;
    const ExactDepth depth(fit.tool_T, fit.scene_W, kFitSpacing);
    const auto beside = [&](double way) {
      return depth.at({fit.X_WT.q, fit.X_WT.p + (fit.clearance + way) * fit.across_W});
    };
    EXPECT_EQ(beside(-0.5e-6), 0) << fit.name;
    EXPECT_NEAR(beside(10e-6), 10e-6, 1e-9) << fit.name;
    EXPECT_EQ(depth.at(turned(fit, 0, 2e-3)), 0) << "it slides";
  }
}

TEST(Fits, NutsRiseAsTheyTurnAndOnlyThen) {
  for (const Fit& fit : fits()) {
    if (fit.pitch == 0) continue;
    const ExactDepth depth(fit.tool_T, fit.scene_W, kFitSpacing);
    for (const double angle : {-2.0, -0.7, 0.4, 3.0})
      EXPECT_EQ(depth.at(turned(fit, angle, fit.pitch * angle / (2 * std::numbers::pi))), 0) << fit.name;
    EXPECT_GT(depth.at(turned(fit, std::numbers::pi, 0)), 2 * fit.clearance) << fit.name;
    EXPECT_GT(depth.at(turned(fit, 0, 0.5 * fit.pitch)), 2 * fit.clearance) << fit.name;
    EXPECT_GT(depth.at(turned(fit, 0, 6 * fit.clearance)), 0) << fit.name;
  }
}

// ISO 965-1, M12: the pitch diameters of 6g are 10.679 to 10.829 mm, those of 6H 10.863 to 11.063 mm. Its
// tables round what its formulas give.
TEST(Fits, ThreadsHaveTheStandardsClearance) {
  const double nut = (10.863e-3 + 11.063e-3) / 2, bolt = (10.679e-3 + 10.829e-3) / 2;
  EXPECT_NEAR(content::thread_clearance({12e-3, 1.75e-3}), (nut - bolt) / 2, 5e-6);
}

}  // namespace
}  // namespace fulcrum::parts
