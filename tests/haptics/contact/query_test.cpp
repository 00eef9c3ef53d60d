// The query against exact distances, its promise about motion, and what it does when too much touches.

#include "haptics/contact/query.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <random>

#include "haptics/bake/triangle_distance.h"
#include "tests/haptics/bake/shapes.h"
#include "tests/haptics/geometry/filled_field.h"
#include "tests/haptics/scenes.h"

namespace fulcrum {
namespace {

// A ring on two crossing bars: concave, convex, thin and wide.
struct QueryScene {
  Solid solid;
  std::shared_ptr<const DistanceField> field;
  TriangleDistance exact;

  explicit QueryScene(const TriangleMesh& mesh)
      : solid(test::expect(build_solid(mesh))),
        field(std::make_shared<DistanceField>(
            test::expect(bake_field(solid, {.voxel_m = 1.5e-3, .band_m = 3e-3})))),
        exact(solid) {}
};

const QueryScene& scene() {
  static const QueryScene built([] {
    TriangleMesh mesh = shapes::torus(0.03, 0.008, 60, 24);
    shapes::append(mesh, shapes::box(Vec3(-0.05, -0.004, -0.005), Vec3(0.05, 0.006, 0.005)));
    shapes::append(mesh, shapes::box(Vec3(-0.006, -0.005, -0.05), Vec3(0.006, 0.005, 0.05)));
    return shapes::rotated(mesh, Quat(0.9, 0.2, -0.3, 0.25).normalized());
  }());
  return built;
}

std::shared_ptr<const Pointshell> ball_shell(std::size_t n, double radius) {
  std::mt19937_64 random(8);
  std::normal_distribution<double> normal;
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < n; ++i)
    points.push_back(radius * Vec3(normal(random), normal(random), normal(random)).normalized());
  return test::shell_of(points);
}

Pose random_pose(std::mt19937_64& random, double spread) {
  std::normal_distribution<double> normal;
  Pose X_WT;
  X_WT.q = Quat(normal(random), normal(random), normal(random), normal(random)).normalized();
  X_WT.p = spread * Vec3(normal(random), normal(random), normal(random));
  return X_WT;
}

// Not unit: differences over a voxel, over it. Near 1 long where there is one direction.
Vec3 slope(const DistanceField& field, const Vec3& p) {
  Vec3 g;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const Vec3 half = 0.5 * field.voxel_m() * Vec3::Unit(axis);
    g[axis] = (field.distance(p + half) - field.distance(p - half)) / field.voxel_m();
  }
  return g;
}

// On a torus of 1 m and 0.3 m, root mean square.
double normals_error(Normals kind, int bricks) {
  const double R = 1, r = 0.3;
  const auto torus = [&](const Vec3& p) { return std::hypot(std::hypot(p.x(), p.z()) - R, p.y()) - r; };
  const auto field = std::make_shared<DistanceField>(filled_field(bricks, 0.4 / bricks, torus));
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> angle(-std::numbers::pi, std::numbers::pi);
  double sum = 0;
  constexpr int sets = 10, size = 200;  // as many as are kept apart
  for (int set_number = 0; set_number < sets; ++set_number) {
    std::vector<Vec3> points;
    for (int i = 0; i < size; ++i) {
      const double a = angle(random), b = angle(random), along = R + r * std::cos(b);
      points.emplace_back(along * std::cos(a), r * std::sin(b), along * std::sin(a));
    }
    ContactQuery query(test::shell_of(points), field, kind);
    ContactSet set;
    query.run({}, set, 0.1);
    EXPECT_EQ(set.contacts().size(), points.size());
    for (const Contact& contact : set.contacts()) {
      const Vec3& p = contact.p_W;
      const Vec3 middle = R * Vec3(p.x(), 0, p.z()).normalized();
      sum += (contact.nhat_W - (p - middle).normalized()).squaredNorm() / (sets * size);
    }
  }
  return std::sqrt(sum);
}

TEST(ContactQuery, NormalsHaveTheOrderTheyPromise) {
  const auto order = [](Normals kind) { return std::log2(normals_error(kind, 8) / normals_error(kind, 16)); };
  EXPECT_NEAR(order(Normals::of_cell), 1, 0.1);
  EXPECT_NEAR(order(Normals::across_cells), 2, 0.1);
  EXPECT_LT(10 * normals_error(Normals::across_cells, 16), normals_error(Normals::of_cell, 16));
}

TEST(ContactQuery, FindsWhatExactDistancesSay) {
  const auto shell = ball_shell(3000, 0.012);
  const DistanceField& field = *scene().field;
  ContactQuery query(shell, scene().field);
  ContactSet set;
  std::mt19937_64 random(1);
  std::size_t touching = 0, directed = 0;
  for (int i = 0; i < 300; ++i) {
    const Pose X_WT = random_pose(random, 0.03);
    const double margin = i % 2 == 0 ? 0.0 : 0.5 * field.band_m();
    const bool complete = query.run(X_WT, set, margin).complete;
    const double error = field.error_bound_m() + query.rounding();
    std::map<std::uint32_t, Contact> found;
    std::uint32_t before = 0;
    for (const Contact& contact : set.contacts()) {
      ASSERT_TRUE(found.empty() || contact.point > before);
      before = contact.point;
      found[contact.point] = contact;
    }
    for (std::uint32_t point = 0; point < shell->size(); ++point) {
      const Vec3 p_W = X_WT * shell->positions[point];
      const double truth = scene().exact.signed_distance(p_W), stored = field.distance(p_W);
      const auto contact = found.find(point);
      if (contact == found.end()) {
        // As the field says, and with it as the surface says.
        if (!complete) continue;
        ASSERT_GE(stored, margin - query.rounding()) << "pose " << i << ", point " << point;
        ASSERT_GE(truth, margin - error) << "pose " << i << ", point " << point;
        continue;
      }
      ++touching;
      ASSERT_LT(truth, margin + error);
      ASSERT_NEAR(-contact->second.depth, stored, query.rounding());
      ASSERT_LT((contact->second.p_W - p_W).norm(), 1e-12);
      ASSERT_NEAR(contact->second.nhat_W.norm(), 1.0, 1e-6);
      const Vec3 across = slope(field, p_W);
      if (across.norm() < 0.9) continue;  // midway between two walls, or where not all is stored
      ASSERT_GT(contact->second.nhat_W.dot(across.normalized()), 0.999);
      ++directed;
    }
  }
  EXPECT_GT(touching, 5000u);
  EXPECT_GT(directed, 3000u);
}

TEST(ContactQuery, NoSafeMotionEntersFartherThanAllowed) {
  const auto shell = ball_shell(400, 0.012);
  ContactQuery query(shell, scene().field);
  ContactSet set;
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> unit(0, 1);
  const double allowance = 0.2e-3;
  int limited = 0, free = 0, used = 0;
  for (int i = 0; i < 1500; ++i) {
    const Pose X_WT = random_pose(random, 0.05);
    query.run(X_WT, set);
    const Vec3 v = 0.02 * unit(random) * Vec3(normal(random), normal(random), normal(random)).normalized();
    const double angle = 1.0 * unit(random);
    const Vec3 axis = Vec3(normal(random), normal(random), normal(random)).normalized();
    const double fraction = query.safe_fraction(v.norm(), angle, allowance);
    ASSERT_GE(fraction, 0.0);
    ASSERT_LE(fraction, 1.0);
    (fraction < 1 ? limited : free) += 1;
    for (const double part : {0.5 * fraction, fraction}) {
      const Pose X_moved{Quat(Eigen::AngleAxisd(part * angle, axis)) * X_WT.q, X_WT.p + part * v};
      for (const Vec3& p_T : shell->positions) {
        const double before = std::min(scene().exact.signed_distance(X_WT * p_T), 0.0);
        const double after = scene().exact.signed_distance(X_moved * p_T);
        ASSERT_GE(after, before - allowance - 1e-9) << "motion " << i;
        if (after < before + 0.5e-3 && fraction < 1) ++used;
      }
    }
  }
  EXPECT_GT(limited, 300);
  EXPECT_GT(free, 100);
  EXPECT_GT(used, 100) << "every motion stopped far from the scene: the promise was not tried";
}

// The other way about: points that stay in W, a ring with bars as the tool.
TEST(ContactQuery, PointsOfTheSceneAreFoundInTheTool) {
  const auto points = ball_shell(800, 0.05);
  const DistanceField& field_T = *scene().field;
  const std::uint32_t first = 4096;
  ContactQuery query = ContactQuery::of_scene(points, scene().field, Normals::across_cells, first, 0.06);
  ContactSet set;
  std::mt19937_64 random(11);
  std::size_t touching = 0;
  for (int i = 0; i < 200; ++i) {
    const Pose X_WT = random_pose(random, 0.03), X_TW = X_WT.inverse();
    const double margin = i % 2 == 0 ? 0.0 : 0.5 * field_T.band_m();
    set.clear();
    ASSERT_TRUE(query.add(X_WT, set, margin).complete);
    std::size_t wanted = 0;
    for (const Vec3& p_W : points->positions)
      wanted += field_T.distance(X_TW * p_W) < margin - query.rounding() ? 1 : 0;
    EXPECT_GE(set.contacts().size(), wanted);
    for (const Contact& contact : set.contacts()) {
      ++touching;
      const Vec3& p_W = points->positions[contact.point - first];
      ASSERT_LT((contact.p_W - p_W).norm(), 1e-12);
      ASSERT_NEAR(-contact.depth, field_T.distance(X_TW * p_W), query.rounding());
      // Along its normal the tool moves out of the point's way.
      const Pose X_away{X_WT.q, X_WT.p + 1e-5 * contact.nhat_W};
      const Vec3 across = slope(field_T, X_TW * p_W);
      if (across.norm() < 0.9) continue;
      ASSERT_GT(contact.nhat_W.dot(-(X_WT.q * across.normalized())), 0.999);
      ASSERT_GT(field_T.distance(X_away.inverse() * p_W), -contact.depth);
    }
  }
  EXPECT_GT(touching, 2000u);
}

TEST(ContactQuery, NoSafeMotionTakesTheToolOverAPointOfTheScene) {
  const auto points = ball_shell(400, 0.05);
  double reach = 0;
  for (const Vec3& p : scene().solid.mesh.vertices) reach = std::max(reach, p.norm());
  ContactQuery query = ContactQuery::of_scene(points, scene().field, Normals::of_cell, 0, reach);
  ContactSet set;
  std::mt19937_64 random(12);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> unit(0, 1);
  const double allowance = 0.2e-3;
  int limited = 0, used = 0;
  for (int i = 0; i < 1000; ++i) {
    const Pose X_WT = random_pose(random, 0.05);
    query.run(X_WT, set);
    const Vec3 v = 0.02 * unit(random) * Vec3(normal(random), normal(random), normal(random)).normalized();
    const double angle = unit(random);
    const Vec3 axis = Vec3(normal(random), normal(random), normal(random)).normalized();
    const double fraction = query.safe_fraction(v.norm(), angle, allowance);
    limited += fraction < 1 ? 1 : 0;
    for (const double part : {0.5 * fraction, fraction}) {
      const Pose X_moved{Quat(Eigen::AngleAxisd(part * angle, axis)) * X_WT.q, X_WT.p + part * v};
      for (const Vec3& p_W : points->positions) {
        const double before = std::min(scene().exact.signed_distance(X_WT.inverse() * p_W), 0.0);
        const double after = scene().exact.signed_distance(X_moved.inverse() * p_W);
        ASSERT_GE(after, before - allowance - 1e-9) << "motion " << i;
        if (after < before + 0.5e-3 && fraction < 1) ++used;
      }
    }
  }
  EXPECT_GT(limited, 200);
  EXPECT_GT(used, 100) << "every motion stopped far from the points: the promise was not tried";
}

// What the hierarchy leaves out changes nothing: as point by point, within rounding.
TEST(ContactQuery, SafeFractionIsThatOfTheWorstPoint) {
  const auto shell = ball_shell(3000, 0.012);
  const DistanceField& field = *scene().field;
  ContactQuery query(shell, scene().field);
  ContactSet set;
  std::mt19937_64 random(4);
  int limited = 0;
  for (int i = 0; i < 200; ++i) {
    const Pose X_WT = random_pose(random, 0.03);
    query.run(X_WT, set);
    const double travel = 1e-3, turn = 0.05, allowance = 0.3e-3;
    // Every other time, what is farther than half a millimetre may not come in.
    const double known = i % 2 == 0 ? std::numeric_limits<double>::infinity() : 0.5e-3;
    double worst = 1;
    for (const Vec3& p_T : shell->positions) {
      const double distance = field.distance(X_WT * p_T);
      double room = std::max(distance - field.error_bound_m(), 0.0) + allowance;
      if (distance >= known) room = std::min(room, std::max(distance - field.error_bound_m(), known));
      worst = std::min(worst, room / (travel + turn * p_T.norm()));
    }
    const double found = query.safe_fraction(travel, turn, allowance, known);
    EXPECT_NEAR(found, worst, 0.01);
    EXPECT_LE(found, worst + 1e-9);
    limited += worst < 1 ? 1 : 0;
  }
  EXPECT_GT(limited, 50);
}

// A slab of n points, all below the floor, deepest towards +x.
std::shared_ptr<const Pointshell> slab(std::size_t side) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < side; ++i) {
    for (std::size_t j = 0; j < side; ++j) {
      const double x = 0.1 * (static_cast<double>(i) / static_cast<double>(side) - 0.5),
                   z = 0.1 * (static_cast<double>(j) / static_cast<double>(side) - 0.5);
      points.emplace_back(x, -0.5e-3 - 0.5e-3 * (x + 0.05), z);
    }
  }
  return test::shell_of(points);
}

TEST(ContactQuery, AHundredThousandTouchingPointsAreTakenTogether) {
  const auto shell = slab(317);
  ASSERT_GT(shell->size(), 100000u);
  ContactQuery query(shell, test::floor_field());
  ContactSet set;
  EXPECT_FALSE(query.run({}, set).complete);
  ASSERT_LE(set.contacts().size(), kMaxContacts);
  ASSERT_GE(set.contacts().size(), kMaxContacts / 4);
  double area = 0, all_area = 0, deepest = 0;
  for (const double own : shell->areas_m2) all_area += own;
  for (std::size_t i = 0; i < set.contacts().size(); ++i) {
    const Contact& contact = set.contacts()[i];
    ASSERT_TRUE(i == 0 || contact.point > set.contacts()[i - 1].point);
    area += contact.overlap.area;
  }
  for (const Vec3& p : shell->positions) deepest = std::max(deepest, -test::floor_field()->distance(p));
  EXPECT_NEAR(area, all_area, 1e-9 * all_area);
  EXPECT_NEAR(set.depth_max(), deepest, query.rounding());
  Box3 box;
  for (const Contact& contact : set.contacts()) box.extend(contact.p_W);
  EXPECT_GT(box.sizes().x(), 0.09);
  EXPECT_GT(box.sizes().z(), 0.09);
}

TEST(ContactQuery, AsManyAsFitAreLeftAsTheyAre) {
  ContactQuery query(slab(16), test::floor_field());
  static_assert(kMaxContacts == 256);
  ContactSet set;
  EXPECT_TRUE(query.run({}, set).complete);
  EXPECT_EQ(set.contacts().size(), 256u);
  ContactQuery more(slab(17), test::floor_field());
  EXPECT_FALSE(more.run({}, set).complete);
  EXPECT_LT(set.contacts().size(), 256u);
  query.run({Quat::Identity(), Vec3(0, 1, 0)}, set);
  EXPECT_TRUE(set.complete());
  EXPECT_TRUE(set.contacts().empty());
}

TEST(ContactSet, ThePatchKeepsItsDeepestPointAndAllOfItsOverlap) {
  ContactSet set;
  for (std::uint32_t i = 0; i < 320; ++i) {
    Contact contact;
    contact.point = i;
    contact.depth = i % 16 == 5 ? 2e-3 : 1e-3;
    contact.overlap = Overlap::of(1.0, contact.depth, contact.p_W);
    set.add(contact);
  }
  ASSERT_EQ(set.contacts().size(), 20u);
  for (std::uint32_t i = 0; i < 20; ++i) {
    EXPECT_EQ(set.contacts()[i].point, 16 * i + 5);
    EXPECT_EQ(set.contacts()[i].overlap.area, 16.0);
    EXPECT_NEAR(set.contacts()[i].overlap.volume, 17e-3, 1e-12);
    EXPECT_NEAR(set.contacts()[i].overlap.mean_depth(), (15e-6 + 4e-6) / 17e-3, 1e-12);
  }
}

}  // namespace
}  // namespace fulcrum
