// Invariant: whatever is done to a sphere's triangles, build_solid() refuses it with a sentence, or answers a
// solid that is inside and outside where the sphere was, but for the neighbourhood of what was taken away.

#include "tests/haptics/bake/truth.h"

namespace fulcrum::test {
namespace {

constexpr double kRadius = 0.03;

TEST(RepairFuzz, ABatteredSphereIsASphereOrRefused) {
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
TEST(RepairFuzz, NonsenseIsAnswered) {
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

// Boxes on a lattice share corners, edges and faces, overlap and pass through each other exactly along edges;
// some are inside out, triangles are missing, turned, repeated, or hang loose. Whatever solid that makes, its
// distance has to be one: it changes no faster than the way, which a wrong sign beside any part of the
// surface would break.
TEST(RepairFuzz, BoxesOnALatticeMakeADistance) {
  int mended_ones = 0;
  for (unsigned seed = 0; seed < 150; ++seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    TriangleMesh mesh;
    for (unsigned i = 0; i < 1 + seed % 4; ++i) {
      const auto step = [&](unsigned n) { return static_cast<double>(random() % n); };
      const Vec3 low(step(3), step(3), step(3)), size(1 + step(2), 1 + step(2), 1 + step(2));
      TriangleMesh box = shapes::grid_box(low, low + size, 1 + static_cast<std::uint32_t>(random() % 4));
      if (random() % 4 == 0)
        for (Triangle& t : box.triangles) std::swap(t[0], t[1]);
      shapes::append(mesh, box);
    }
    const double deletions = 0.1 * std::pow(unit(random), 2), flips = seed % 2 == 0 ? 0.0 : unit(random);
    std::vector<Triangle> battered;
    for (Triangle t : mesh.triangles) {
      if (unit(random) < deletions) continue;
      if (unit(random) < flips) std::swap(t[1], t[2]);
      battered.push_back(t);
      if (unit(random) < 0.05) battered.push_back({t[1], t[2], t[0]});
      if (unit(random) < 0.02)
        battered.push_back({t[1], t[2], static_cast<std::uint32_t>(random() % mesh.vertices.size())});
    }
    mesh.triangles = battered;
    const auto solid = build_solid(mesh);
    if (!solid) continue;
    ++mended_ones;
    const TriangleDistance exact(*solid);
    std::uniform_real_distribution<double> anywhere(-0.5, 4.5), nearby(-0.03, 0.03);
    for (int i = 0; i < 300; ++i) {
      const Vec3 p(anywhere(random), anywhere(random), anywhere(random));
      const Vec3 way(nearby(random), nearby(random), nearby(random));
      ASSERT_LE(std::abs(exact.signed_distance(p) - exact.signed_distance(p + way)), way.norm() + 1e-9)
          << "seed " << seed << " at " << p.transpose();
    }
  }
  EXPECT_GT(mended_ones, 75);
}

}  // namespace
}  // namespace fulcrum::test
