#pragma once
// A solid's distance held against the truth at many places: on the grid it is baked to, and exactly.

#include <gtest/gtest.h>

#include <functional>
#include <random>
#include <string>

#include "haptics/bake/field_bake.h"
#include "haptics/bake/triangle_distance.h"
#include "tests/haptics/bake/shapes.h"

namespace fulcrum::test {

using Truth = std::function<double(const Vec3&)>;  // signed distance in m

inline Solid repaired(const TriangleMesh& mesh) {
  auto solid = build_solid(mesh);
  EXPECT_TRUE(solid) << solid.error().sentence;
  return solid ? *solid : Solid{};
}

inline bool tells(const Solid& solid, const std::string& words) {
  for (const std::string& note : solid.notes)
    if (note.find(words) != std::string::npos) return true;
  return false;
}

inline std::string all_notes(const Solid& solid) {
  std::string all;
  for (const std::string& note : solid.notes) all += note + "\n";
  return all;
}

// Uniform in the solid's bounds, grown by a fifth; every other place within a hundredth of the surface.
inline std::vector<Vec3> places_about(const Solid& solid, int n) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> unit(-0.7, 0.7);
  std::normal_distribution<double> near(0.0, 0.004 * solid.bounds().diagonal().norm());
  std::uniform_int_distribution<std::size_t> which(0, solid.mesh.triangles.size() - 1);
  std::vector<Vec3> places;
  for (int i = 0; i < n; ++i) {
    const Vec3 r(unit(random), unit(random), unit(random));
    const Vec3 offset(near(random), near(random), near(random));
    const Triangle& t = solid.mesh.triangles[which(random)];
    Vec3 on = solid.mesh.vertices[t[0]];
    on += std::abs(r.x()) * (solid.mesh.vertices[t[1]] - on);
    on += std::abs(r.y()) * (solid.mesh.vertices[t[2]] - on);
    places.push_back(i % 2 == 0 ? Vec3(solid.bounds().center() + r.cwiseProduct(solid.bounds().sizes()))
                                : Vec3(on + offset));
  }
  return places;
}

inline void expect_distance(const Solid& solid, const Truth& truth, double tolerance, int n = 6000) {
  ASSERT_FALSE(solid.components.empty());
  const TriangleDistance exact(solid);
  for (const Vec3& p : places_about(solid, n)) {
    ASSERT_NEAR(exact.signed_distance(p), truth(p), tolerance) << p.transpose();
    const ClosestPoint closest = exact.closest(p);
    ASSERT_GE((p - closest.point).dot(closest.normal) * truth(p), -tolerance) << p.transpose();
  }
}

inline void expect_field(const Solid& solid, const Truth& truth, double voxel) {
  const auto field = bake_field(solid, {voxel, 2.0 * voxel, FieldFormat::float32});
  ASSERT_TRUE(field) << field.error().sentence;
  for (const Vec3& p : places_about(solid, 6000)) {
    const FieldSample found = field->sample(p);
    if (found.in_band)
      ASSERT_NEAR(found.distance, truth(p), 0.87 * voxel) << p.transpose();
    else if (std::abs(found.distance) > voxel)
      ASSERT_EQ(found.distance < 0.0, truth(p) < 0.0) << p.transpose();
  }
}

}  // namespace fulcrum::test
