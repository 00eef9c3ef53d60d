// Invariant: whatever is done to a sphere's triangles, build_solid() refuses it with a sentence, or answers a
// solid that is inside and outside where the sphere was, but for the neighbourhood of what was taken away.

#include "tests/haptics/bake/truth.h"

namespace fulcrum::test {
namespace {

constexpr double kRadius = 0.03;

TEST(MendFuzz, ABatteredSphereIsASphereOrRefused) {
  const TriangleMesh whole = shapes::sphere(Vec3::Zero(), kRadius, 14);
  int mended_ones = 0, refused = 0;
  for (unsigned seed = 0; seed < 120; ++seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const double deletions = 0.12 * unit(random), flips = unit(random), repeats = 0.3 * unit(random);
    TriangleMesh mesh{whole.vertices, {}};
    std::vector<Vec3> gone;
    for (Triangle t : whole.triangles) {
      const Vec3 centre = (whole.vertices[t[0]] + whole.vertices[t[1]] + whole.vertices[t[2]]) / 3.0;
      if (unit(random) < deletions) {
        gone.push_back(centre);
        continue;
      }
      if (unit(random) < flips) std::swap(t[1], t[2]);
      mesh.triangles.push_back(t);
      if (unit(random) < repeats) mesh.triangles.push_back({t[2], t[0], t[1]});
      if (unit(random) < 0.3 * repeats) mesh.triangles.push_back({t[1], t[0], t[2]});
    }
    std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), random);

    const auto solid = build_solid(mesh);
    if (!solid) {
      ++refused;
      ASSERT_GT(solid.error().sentence.size(), 40u);
      ASSERT_EQ(solid.error().sentence.back(), '.');
      continue;
    }
    ++mended_ones;
    ASSERT_FALSE(solid->notes.empty());
    const TriangleDistance exact(*solid);
    for (const Vec3& p : places_about(*solid, 1500)) {
      const double truth = p.norm() - kRadius;
      if (std::abs(truth) < 0.03 * kRadius) continue;  // the facets' own
      double away = 1e9;
      for (const Vec3& q : gone) away = std::min(away, (p - q).norm());
      if (std::abs(truth) < 0.6 * kRadius && away < 0.7 * kRadius) continue;
      ASSERT_EQ(exact.signed_distance(p) < 0.0, truth < 0.0) << "seed " << seed << " at " << p.transpose();
    }
  }
  EXPECT_GT(mended_ones, 60);
  EXPECT_LT(refused, 60);
}

// Triangles of random corners mean nothing; they must be answered all the same.
TEST(MendFuzz, NonsenseIsAnswered) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    std::mt19937_64 random(seed);
    TriangleMesh mesh;
    std::uniform_real_distribution<double> anywhere(-1.0, 1.0);
    const std::uint32_t vertices = 4 + seed % 12;
    for (std::uint32_t i = 0; i < vertices; ++i)
      mesh.vertices.emplace_back(anywhere(random), anywhere(random), anywhere(random));
    std::uniform_int_distribution<std::uint32_t> which(0, vertices - 1);
    for (unsigned i = 0; i < 1 + seed; ++i)
      mesh.triangles.push_back({which(random), which(random), which(random)});
    const auto solid = build_solid(mesh);
    if (!solid) {
      ASSERT_EQ(solid.error().sentence.back(), '.') << solid.error().sentence;
      continue;
    }
    const TriangleDistance exact(*solid);
    for (const Vec3& p : places_about(*solid, 200)) ASSERT_TRUE(std::isfinite(exact.signed_distance(p)));
  }
}

}  // namespace
}  // namespace fulcrum::test
