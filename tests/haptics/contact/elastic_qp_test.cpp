#include "haptics/contact/elastic_qp.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace fulcrum {
namespace {

constexpr double kSlack = 1e7;

Vec6 metric() {
  Vec6 m;
  m << 800, 800, 800, 1.5, 1.5, 1.5;
  return m;
}

QpRow row(const Vec3& nhat, const Vec3& r, double b) {
  QpRow made;
  made.a << nhat, r.cross(nhat);
  made.b = b;
  return made;
}

// Feasible up to the slack, no row pulls, forces balance, rows that push are met: what makes it the minimum.
void expect_optimal(const Vec6& goal, const std::vector<QpRow>& rows, double slack_stiffness) {
  ElasticQp qp(metric(), slack_stiffness);
  std::vector<double> multipliers(rows.size());
  const ElasticQp::Solution solution = qp.solve(goal, rows, multipliers);
  EXPECT_TRUE(solution.exact);
  Vec6 force = metric().cwiseProduct(goal - solution.x);
  double total = 0, largest = force.norm();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_GE(multipliers[i], 0.0);
    force += multipliers[i] * rows[i].a;
    total += multipliers[i];
  }
  const double s = total / slack_stiffness;
  EXPECT_LT(force.norm(), 1e-7 * (1 + largest)) << "forces do not balance";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double room = rows[i].a.dot(solution.x) + s - rows[i].b;
    EXPECT_GT(room, -1e-9) << "row " << i << " is broken";
    EXPECT_TRUE(multipliers[i] < 1e-6 || room < 1e-8) << "row " << i << " pushes from afar";
  }
}

TEST(ElasticQp, WithoutRowsTheGoalIsReached) {
  ElasticQp qp(metric(), kSlack);
  Vec6 goal;
  goal << 1, 2, 3, 0.1, 0.2, 0.3;
  EXPECT_LT((qp.solve(goal, {}, {}).x - goal).norm(), 1e-15);
}

TEST(ElasticQp, APlaneStopsWhatGoesAgainstItAlone) {
  ElasticQp qp(metric(), kSlack);
  Vec6 goal = Vec6::Zero();
  goal.head<3>() = Vec3(0.3, -0.2, 0.1);
  const QpRow floor = row({0, 1, 0}, Vec3::Zero(), -0.05);
  double force = 0;
  const Vec6 x = qp.solve(goal, {&floor, 1}, {&force, 1}).x;
  EXPECT_NEAR(x[0], 0.3, 1e-12);
  EXPECT_NEAR(x[1], -0.05, 2e-5);
  EXPECT_NEAR(force, 800 * 0.15, 0.02);
}

TEST(ElasticQp, RandomRowsGiveTheMinimum) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  const auto vector = [&] { return Vec3(normal(random), normal(random), normal(random)); };
  for (int problem = 0; problem < 300; ++problem) {
    std::vector<QpRow> rows;
    const int count = 1 + problem % 200;
    for (int i = 0; i < count; ++i)
      rows.push_back(row(vector().normalized(), 0.1 * vector(), -std::abs(1e-3 * normal(random))));
    Vec6 goal;
    goal << 0.01 * vector(), 0.1 * vector();
    expect_optimal(goal, rows, kSlack);
  }
}

// Good, bad and impossible guesses alike; a good one needs no iteration.
TEST(ElasticQp, AGuessChangesNothingButTheWay) {
  std::mt19937_64 random(13);
  std::normal_distribution<double> normal;
  const auto vector = [&] { return Vec3(normal(random), normal(random), normal(random)); };
  ElasticQp qp(metric(), kSlack);
  int cold = 0;
  for (int problem = 0; problem < 300; ++problem) {
    std::vector<QpRow> rows;
    for (int i = 0; i < 1 + problem % 100; ++i)
      rows.push_back(row(vector().normalized(), 0.1 * vector(), -std::abs(1e-3 * normal(random))));
    Vec6 goal;
    goal << 0.01 * vector(), 0.1 * vector();
    std::vector<double> forces(rows.size());
    const ElasticQp::Solution without = qp.solve(goal, rows, forces);
    cold += without.iterations;
    const ElasticQp::Solution again = qp.solve(goal, rows, forces);
    EXPECT_EQ(again.iterations, 0) << problem;
    EXPECT_LT((again.x - without.x).norm(), 1e-10);
    for (double& force : forces) force = normal(random);
    const ElasticQp::Solution misled = qp.solve(goal, rows, forces);
    EXPECT_TRUE(misled.exact);
    EXPECT_LT((misled.x - without.x).norm(), 1e-9) << problem;
  }
  EXPECT_GT(cold, 1000);
}

// A hundred times the same wall, give or take rounding, and all others besides.
TEST(ElasticQp, RedundantRowsChangeNothing) {
  const QpRow floor = row({0, 1, 0}, Vec3(0.01, 0, 0.02), -1e-3);
  Vec6 goal;
  goal << 0.01, -0.02, 0.005, 0.05, -0.1, 0.2;
  ElasticQp qp(metric(), kSlack);
  double force = 0;
  const Vec6 alone = qp.solve(goal, {&floor, 1}, {&force, 1}).x;
  std::vector<QpRow> rows(100, floor);
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].a[0] += 1e-15 * static_cast<double>(i);
  std::vector<double> forces(rows.size());
  const ElasticQp::Solution many = qp.solve(goal, rows, forces);
  EXPECT_TRUE(many.exact);
  EXPECT_LT((many.x - alone).norm(), 1e-9);
  double total = 0;
  for (const double f : forces) total += f;
  EXPECT_NEAR(total, force, 1e-6 * force);
  expect_optimal(goal, rows, kSlack);
}

// Two walls that leave no room: the tool stands where both are broken alike.
TEST(ElasticQp, ConflictingRowsAreBrokenEvenly) {
  const std::vector<QpRow> rows{row({0, 1, 0}, Vec3::Zero(), 2e-4), row({0, -1, 0}, Vec3::Zero(), 0.0)};
  ElasticQp qp(metric(), kSlack);
  std::vector<double> forces(2);
  Vec6 goal = Vec6::Zero();
  goal[1] = -0.01;
  const ElasticQp::Solution solution = qp.solve(goal, rows, forces);
  EXPECT_TRUE(solution.exact);
  EXPECT_NEAR(solution.x[1], 1e-4, 2e-6);
  EXPECT_GT(forces[0], 0);
  EXPECT_GT(forces[1], 0);
  expect_optimal(goal, rows, kSlack);
}

TEST(ElasticQp, AnySizeOfNumbersEnds) {
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  const auto vector = [&] { return Vec3(normal(random), normal(random), normal(random)); };
  for (const double size : {1e-12, 1e-6, 1.0, 1e6}) {
    for (int problem = 0; problem < 100; ++problem) {
      std::vector<QpRow> rows;
      for (int i = 0; i < 60; ++i) {
        // A handful of normals over and over: corners of a box against the walls of a slot.
        Vec3 nhat = Vec3::Zero();
        nhat[i % 3] = i % 2 == 0 ? 1 : -1;
        rows.push_back(row(nhat, vector(), size * normal(random)));
      }
      ElasticQp qp(metric(), kSlack);
      std::vector<double> forces(rows.size());
      Vec6 goal;
      goal << size * vector(), size * vector();
      const ElasticQp::Solution solution = qp.solve(goal, rows, forces);
      EXPECT_TRUE(solution.x.allFinite());
      EXPECT_TRUE(solution.exact) << size << ' ' << problem << ' ' << solution.iterations;
    }
  }
}

}  // namespace
}  // namespace fulcrum
