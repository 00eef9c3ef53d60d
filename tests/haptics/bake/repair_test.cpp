// Surfaces as modelling programs leave them. Every one that is repaired has its distance held against what
// was meant, everywhere, and says what was done; every one that is refused says where and why.

#include <algorithm>
#include <random>

#include "haptics/bake/mass_properties.h"
#include "haptics/bake/pointshell_bake.h"
#include "tests/haptics/bake/truth.h"

namespace fulcrum::test {
namespace {

const Vec3 kLow(-0.04, -0.03, -0.02), kHigh(0.04, 0.03, 0.02);

TriangleMesh fine_box() {
  return shapes::grid_box(kLow, kHigh, 8);
}

double box_truth(const Vec3& p) {
  return shapes::box_distance(p, kLow, kHigh);
}

void expect_the_box(const Solid& solid) {
  expect_distance(solid, box_truth, 1e-9);
  EXPECT_NEAR(mass_properties(solid).volume_m3, (kHigh - kLow).prod(), 1e-12) << all_notes(solid);
}

std::string refusal(const TriangleMesh& mesh) {
  const auto solid = build_solid(mesh);
  return solid ? "" : solid.error().sentence;
}

void flip(Triangle& t) {
  std::swap(t[1], t[2]);
}

void remove_near(TriangleMesh& mesh, const Vec3& place, double radius) {
  std::erase_if(
      mesh.triangles,
      [&](const Triangle& t) {
        return ((mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0 - place).norm() <
               radius;
      });
}

TEST(Repair, SoundSurfacesAreLeftAsTheyAre) {
  const Solid solid = repaired(fine_box());
  EXPECT_TRUE(solid.notes.empty()) << all_notes(solid);
  EXPECT_TRUE(solid.components[0].shell.triangles.empty());
  EXPECT_EQ(solid.mesh.triangles.size(), fine_box().triangles.size());
}

TEST(Repair, AHoleIsFilledAndTold) {
  TriangleMesh mesh = fine_box();
  remove_near(mesh, Vec3(0.04, 0, 0), 0.006);
  ASSERT_LT(mesh.triangles.size(), fine_box().triangles.size() - 5);
  const Solid solid = repaired(mesh);
  expect_the_box(solid);
  expect_field(solid, box_truth, 1e-3);
  ASSERT_EQ(solid.notes.size(), 1u) << all_notes(solid);
  EXPECT_TRUE(tells(solid, "mm wide around (0.04, ")) << all_notes(solid);
  EXPECT_TRUE(tells(solid, "inside is a guess within")) << all_notes(solid);
}

// A hole over an edge of the box: what was meant there nobody knows, elsewhere it is right.
TEST(Repair, AwayFromAHoleNothingIsGuessed) {
  TriangleMesh mesh = fine_box();
  const Vec3 corner = kHigh;
  remove_near(mesh, corner, 0.01);
  const Solid solid = repaired(mesh);
  const TriangleDistance exact(solid);
  for (const Vec3& p : places_about(solid, 6000)) {
    if ((p - corner).norm() < 0.03) continue;
    ASSERT_NEAR(exact.signed_distance(p), box_truth(p), (p - corner).norm() < 0.06 ? 0.01 : 1e-9);
    ASSERT_EQ(exact.signed_distance(p) < 0.0, box_truth(p) < 0.0) << p.transpose();
  }
}

TEST(Repair, AMissingFaceIsRefused) {
  TriangleMesh mesh = fine_box();
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](std::uint32_t v) { return mesh.vertices[v].x() == 0.04; });
  });
  const std::string sentence = refusal(mesh);
  EXPECT_NE(sentence.find("wide around (0.04, 0, 0) m is more than can be filled"), std::string::npos)
      << sentence;
  EXPECT_NE(sentence.find("close it where the model was made"), std::string::npos) << sentence;
}

TEST(Repair, FlippedTrianglesAreTurned) {
  TriangleMesh mesh = fine_box();
  std::mt19937_64 random(3);
  for (Triangle& t : mesh.triangles)
    if (random() % 3 == 0) flip(t);
  const Solid solid = repaired(mesh);
  expect_the_box(solid);
  EXPECT_TRUE(tells(solid, "wound against the rest and have been turned, the first at ("))
      << all_notes(solid);
}

TEST(Repair, FlippedTrianglesAboutAHoleAreTurned) {
  TriangleMesh mesh = fine_box();
  remove_near(mesh, Vec3(0.04, 0, 0), 0.006);
  std::mt19937_64 random(4);
  for (Triangle& t : mesh.triangles)
    if (random() % 4 != 0) flip(t);
  expect_the_box(repaired(mesh));
}

TEST(Repair, ABodyInsideOutIsTurned) {
  TriangleMesh mesh = fine_box();
  for (Triangle& t : mesh.triangles) flip(t);
  const Solid solid = repaired(mesh);
  expect_the_box(solid);
  EXPECT_TRUE(tells(solid, "was wound inside out and has been turned")) << all_notes(solid);
}

TEST(Repair, RepeatedTrianglesAreLeftOut) {
  TriangleMesh mesh = fine_box();
  const std::vector<Triangle> once = mesh.triangles;
  for (std::size_t i = 0; i < once.size(); i += 3)
    mesh.triangles.push_back({once[i][1], once[i][2], once[i][0]});
  const Solid some = repaired(mesh);
  expect_the_box(some);
  EXPECT_TRUE(tells(some, "repeat others and are left out, the first at (")) << all_notes(some);

  TriangleMesh two_sided = fine_box();
  two_sided.triangles.pop_back();  // so that something is to be repaired
  for (Triangle t : std::vector<Triangle>(two_sided.triangles)) {
    flip(t);
    two_sided.triangles.push_back(t);
  }
  two_sided.triangles.pop_back();
  expect_the_box(repaired(two_sided));
}

// The same face once more, cut along the other diagonal: no triangle repeats another.
TEST(Repair, AFaceLaidOverAFaceIsLeftOut) {
  TriangleMesh mesh = shapes::box(kLow, kHigh);
  mesh.triangles.push_back({4, 5, 6});
  mesh.triangles.push_back({5, 7, 6});
  const Solid solid = repaired(mesh);
  expect_the_box(solid);
  EXPECT_TRUE(tells(solid, "A sheet of 2 triangles")) << all_notes(solid);
}

TEST(Repair, SliversAreLeftOut) {
  TriangleMesh mesh = shapes::box(kLow, kHigh);
  const auto beside = static_cast<std::uint32_t>(mesh.vertices.size());
  const Vec3 middle = 0.5 * (mesh.vertices[4] + mesh.vertices[7]);
  mesh.vertices.push_back(middle);                          // on the diagonal of the upper face
  mesh.vertices.push_back(middle + Vec3(1e-13, 0.0, 0.0));  // and hardly off it
  mesh.triangles.resize(10);
  mesh.triangles.insert(mesh.triangles.end(), {{4, 5, beside + 1},
                                               {5, 7, beside + 1},
                                               {4, beside + 1, beside},
                                               {beside, beside + 1, 7},
                                               {4, beside, 6},
                                               {beside, 7, 6}});
  const Solid solid = repaired(mesh);
  expect_the_box(solid);
  EXPECT_TRUE(tells(solid, "2 triangles without height are left out, the first at (-0.04, -0.03, 0.02) m."))
      << all_notes(solid);
  EXPECT_EQ(solid.mesh.triangles.size(), 14u);
}

// The ridge of a wedge of 20 degrees is one edge on one side and three on the other.
TEST(Repair, TJunctionsAreClosed) {
  const double half = 0.01 * std::tan(0.1745);
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0},        {0, 0, 0.03},        {0.01, half, 0}, {0.01, half, 0.03},
                   {0.01, -half, 0}, {0.01, -half, 0.03}, {0, 0, 0.01},    {0, 0, 0.02}};
  mesh.triangles = {{0, 1, 2}, {1, 3, 2},                        // above, the ridge in one
                    {0, 4, 6}, {6, 4, 7}, {7, 4, 5}, {7, 5, 1},  // below, in three
                    {2, 3, 4}, {4, 3, 5}, {0, 2, 4}, {1, 5, 3}};
  const Solid solid = repaired(mesh);
  const Vec3 n(-std::sin(0.1745), std::cos(0.1745), 0);
  const auto truth = [&](const Vec3& p) {  // of the three planes and the two ends, where none is near an edge
    return std::max({n.dot(p), Vec3(n.x(), -n.y(), 0).dot(p), p.x() - 0.01, -p.z(), p.z() - 0.03});
  };
  const TriangleDistance exact(solid);
  for (const Vec3& p : places_about(solid, 6000))
    ASSERT_EQ(exact.signed_distance(p) < 0.0, truth(p) < 0.0) << p.transpose();
  for (double z = 0.001; z < 0.03; z += 0.0007) {
    EXPECT_NEAR(exact.signed_distance(Vec3(-0.004, 0.001, z)), std::hypot(0.004, 0.001), 1e-9);
    EXPECT_NEAR(exact.signed_distance(Vec3(-0.001, 0.004, z)), 0.004123, 1e-3);
  }
  EXPECT_TRUE(tells(solid, "on them: 2 places, the first at (0, 0, 0.01) m.")) << all_notes(solid);
}

// Exported face by face in single precision: no two faces share a vertex.
TEST(Repair, CracksAreClosed) {
  TriangleMesh mesh = shapes::grid_box(kLow, kHigh, 8);
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> noise(-1e-7, 1e-7);
  for (Vec3& p : mesh.vertices) p += Vec3(noise(random), noise(random), noise(random));
  const Solid solid = repaired(mesh);
  expect_distance(solid, box_truth, 1e-6);
  EXPECT_TRUE(tells(solid, "Cracks narrower than")) << all_notes(solid);
  EXPECT_TRUE(tells(solid, "vertices moved, the first at (")) << all_notes(solid);
}

TEST(Repair, AFinIsLeftOutAndTold) {
  for (const Vec3& tip :
       {Vec3(0, 0, 0.05), Vec3(0.01, 0.02, 0.035), Vec3(0, 0, -0.005)}) {  // the last inside
    TriangleMesh mesh = fine_box();
    const auto top = [&](double x) {
      const auto is_it = [&](const Vec3& p) { return (p - Vec3(x, 0, 0.02)).norm() < 1e-9; };
      return static_cast<std::uint32_t>(std::find_if(mesh.vertices.begin(), mesh.vertices.end(), is_it) -
                                        mesh.vertices.begin());
    };
    mesh.vertices.push_back(tip);
    mesh.triangles.push_back({top(0), top(0.01), static_cast<std::uint32_t>(mesh.vertices.size() - 1)});
    const Solid solid = repaired(mesh);
    expect_the_box(solid);
    EXPECT_TRUE(tells(solid, "A sheet of 1 triangle around")) << all_notes(solid);
  }
}

// Two boxes that share a wall, as a volume mesher or a lazy modeller leaves them.
TEST(Repair, AWallInsideIsLeftOut) {
  TriangleMesh mesh = shapes::box(kLow, Vec3(0, kHigh.y(), kHigh.z()));
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](std::uint32_t v) { return mesh.vertices[v].x() == 0.0; });
  });
  shapes::append(mesh, shapes::box(Vec3(0, kLow.y(), kLow.z()), kHigh));
  const Solid solid = repaired(mesh);
  expect_the_box(solid);
  EXPECT_TRUE(tells(solid, "lies inside a body")) << all_notes(solid);
}

TEST(Repair, ASphereInsideOutInASphereIsACavity) {
  TriangleMesh mesh = shapes::sphere(Vec3::Zero(), 0.03, 40);
  TriangleMesh inner = shapes::sphere(Vec3(0.002, 0, 0), 0.02, 40);
  for (Triangle& t : inner.triangles) flip(t);
  shapes::append(mesh, inner);
  shapes::append(mesh, shapes::sphere(Vec3(0.002, 0, 0), 0.01, 40));  // and a ball in it
  const Solid solid = repaired(mesh);
  ASSERT_EQ(solid.components.size(), 2u);
  EXPECT_TRUE(solid.notes.empty()) << all_notes(solid);
  const auto truth = [](const Vec3& p) {
    const double r = (p - Vec3(0.002, 0, 0)).norm();
    return std::min(std::max(p.norm() - 0.03, 0.02 - r), r - 0.01);
  };
  expect_distance(solid, truth, 6e-5);
  expect_field(solid, truth, 1e-3);
  const double volume = 4.0 / 3.0 * std::numbers::pi * (27 - 8 + 1) * 1e-6;
  EXPECT_NEAR(mass_properties(solid).volume_m3, volume, 0.01 * volume);
}

TEST(Repair, SheetsAreRefused) {
  TriangleMesh sheet;
  sheet.vertices = {{0, 0, 0}, {0.1, 0, 0}, {0, 0, 0.1}, {0.1, 0, 0.1}};
  sheet.triangles = {{0, 1, 2}, {1, 3, 2}};
  EXPECT_NE(
      refusal(sheet).find("A sheet of 2 triangles around (0.05, 0, 0.05) m, 141.4 mm across, bounds nothing: "
                          "give it thickness"),
      std::string::npos)
      << refusal(sheet);

  TriangleMesh beside = fine_box();  // a sound body does not excuse it
  shapes::append(beside, sheet);
  EXPECT_NE(refusal(beside).find("bounds nothing"), std::string::npos) << refusal(beside);

  TriangleMesh strip;  // of Moebius
  constexpr std::uint32_t n = 24;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double a = 2.0 * std::numbers::pi * i / n;
    const Vec3 out(std::cos(a), 0, std::sin(a));
    const Vec3 across = std::cos(a / 2) * out + std::sin(a / 2) * Vec3::UnitY();
    strip.vertices.push_back(0.05 * out + 0.01 * across);
    strip.vertices.push_back(0.05 * out - 0.01 * across);
    const std::uint32_t l = 2 * i, r = l + 1, nl = i + 1 < n ? l + 2 : 1, nr = i + 1 < n ? l + 3 : 0;
    strip.triangles.insert(strip.triangles.end(), {{l, r, nl}, {r, nr, nl}});
  }
  EXPECT_NE(refusal(strip).find("has one side only"), std::string::npos) << refusal(strip);
}

TEST(Repair, WhatIsRepairedMakesAShellToo) {
  TriangleMesh mesh = fine_box();
  remove_near(mesh, Vec3(0.04, 0, 0), 0.006);
  flip(mesh.triangles[17]);
  const auto shell = bake_pointshell(repaired(mesh), {.spacing_m = 4e-3});
  ASSERT_TRUE(shell) << shell.error().sentence;
  double area = 0.0;
  for (const double a : shell->areas_m2) area += a;
  const Vec3 s = kHigh - kLow;
  EXPECT_NEAR(area, 2.0 * (s.x() * s.y() + s.y() * s.z() + s.z() * s.x()), 1e-9);
  for (std::size_t i = 0; i < shell->size(); ++i)
    EXPECT_GT(box_truth(shell->positions[i] + 1e-3 * shell->normals[i]), 0.0);
}

}  // namespace
}  // namespace fulcrum::test
