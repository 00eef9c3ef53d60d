// Contact on triangles, in hands that are rough with parts of a few micrometres of clearance: judged on the
// triangles by what shares no code with it. Afterwards the hand goes back, and a part that is held comes too.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <string>

#include "haptics/bake/field_bake.h"
#include "haptics/bake/pointshell_bake.h"
#include "haptics/bake/solid.h"
#include "haptics/math/rotation.h"
#include "haptics/math/split_mix.h"
#include "haptics/safety/faults.h"
#include "haptics/world/world.h"
#include "tests/parts/content_mesh.h"
#include "tests/parts/exact_depth.h"
#include "tests/parts/fits.h"
#include "tests/parts/in_hand.h"
#include "tools/content/mesh/metric_thread.h"

namespace fulcrum::parts {
namespace {

constexpr double kAsked = 10e-6;  // m

SceneDesc on_triangles(const Fit& fit) {
  SceneDesc desc = in_hand(fit.tool_T, fit.scene_W);
  desc.tool.X_WT_start = fit.X_WT;
  return desc;
}

// ticks: of each hand. every: which of them are judged.
void be_rough_with(const Fit& fit, int ticks, int every) {
  const SceneDesc desc = on_triangles(fit);
  const ExactDepth judge(fit.tool_T, fit.scene_W, 0.4e-3);
  SplitMix random(7);
  const auto any = [&] { return 2 * random.uniform() - 1; };
  const auto near = [&](const Vec3& turn, const Vec3& shift) {
    return Pose{quaternion_exp(turn) * fit.X_WT.q, fit.X_WT.p + shift};
  };
  for (const std::string hand : {"struck", "leaned on", "shaken", "spun"}) {
    Result<World> world = World::build(desc);
    ASSERT_TRUE(world) << world.error().sentence;
    double judged = 0, reported = 0;
    for (int i = 0; i < ticks; ++i) {
      const double s = i * desc.tick_s;
      Pose X = fit.X_WT;
      if (hand == "struck")
        X = near(Vec3::Zero(), 10e-3 * std::sin(100 * s) * fit.across_W);
      else if (hand == "leaned on")
        X = near(0.2 * std::sin(20 * s) * fit.way_W.cross(fit.across_W), 1e-3 * std::sin(50 * s) * fit.way_W);
      else if (hand == "shaken")
        X = near(0.05 * Vec3(any(), any(), any()), 2e-3 * Vec3(any(), any(), any()));
      else
        X = near(12 * s * fit.way_W, 1e-3 * fit.across_W);
      const StepResult result = tick(*world, desc, X);
      reported = std::max(reported, result.record.depth_max);
      if (i % every == 0) judged = std::max(judged, judge.at(result.record.X_WT));
    }
    EXPECT_LE(judged, kAsked) << fit.name << ' ' << hand;
    EXPECT_NEAR(reported, judged, 2e-6) << fit.name << ' ' << hand;
    // A spring that was wound by more than half a turn stays wound, and a gear may have gone on by a tooth.
    if (hand == "spun" || fit.name == "gear on gear") continue;
    StepResult result;
    for (int i = 0; i < 50; ++i) result = tick(*world, desc, fit.X_WT);
    EXPECT_LT((result.record.X_WT.p - fit.X_WT.p).norm(), kAsked) << fit.name << ' ' << hand;
    EXPECT_LT(angle_between(result.record.X_WT.q, fit.X_WT.q), 1e-3) << fit.name << ' ' << hand;
  }
}

bool is(const Fit& fit, std::initializer_list<const char*> names) {
  return std::ranges::any_of(
      names, [&](const char* name) { return fit.name == name; });
}

TEST(ExactContact, KeepsASquarePegAndAKeyOutOfTheWalls) {
  for (const Fit& fit : fits())
    if (is(fit, {"square peg 4 mm", "key in a lock"})) be_rough_with(fit, 60, 6);
}

TEST(ExactContact, KeepsRoundPegsGearsHingesAndCombsOutOfTheWallsLong) {
  for (const Fit& fit : fits())
    if (is(fit, {"round peg 4 mm", "round peg 16 mm", "square peg 16 mm", "gear on gear", "hinge",
                 "comb in comb"}))
      be_rough_with(fit, 400, 10);
}

// Parts of another size, told of in a frame that is turned and may lie far off them, in a hand that leaps by
// millimetres, slides at up to 0.5 m/s and turns at up to 16 rad/s.
class AnySize {
public:
  explicit AnySize(std::uint64_t seed) : random_(seed) {}

  void leap_about(const Fit& made, bool far_off, double friction, int ticks, int every) {
    const double scale = std::pow(10.0, any(0.8));
    const Vec3 shift = far_off ? in_cube(0.2) : Vec3(Vec3::Zero());
    const Quat turn = quaternion_exp(in_cube(2));
    Fit fit = made;
    for (Vec3& p : fit.tool_T.vertices) p = turn * (scale * p) + shift;
    for (Vec3& p : fit.scene_W.vertices) p *= scale;
    fit.X_WT.q = (fit.X_WT.q * turn.conjugate()).normalized();
    fit.X_WT.p = scale * fit.X_WT.p - fit.X_WT.q * shift;
    SceneDesc desc = on_triangles(fit);
    desc.contact.friction = friction;
    const ExactDepth judge(fit.tool_T, fit.scene_W, 0.25e-3 * scale);
    Result<World> world = World::build(desc);
    ASSERT_TRUE(world) << world.error().sentence;
    Vec3 p = Vec3::Zero(), v = Vec3::Zero(), turned = Vec3::Zero(), w = Vec3::Zero();
    for (int i = 0; i < ticks; ++i) {
      if (i % 50 == 0) {
        v = in_cube(std::pow(10.0, any(1.2) - 1.5));
        w = in_cube(std::pow(10.0, any(1.2)));
      }
      if (i % 173 == 7) {
        p = in_cube(5e-3 * scale);
        turned = in_cube(0.5);
      }
      if (i % 400 == 399) p = turned = Vec3::Zero();
      p += desc.tick_s * v;
      turned += desc.tick_s * w;
      if (p.norm() > 0.02 * scale) p *= 0.5;
      Pose X{(quaternion_exp(turned) * fit.X_WT.q).normalized(), Vec3::Zero()};
      X.p = fit.X_WT * shift - X.q * shift + p;
      const StepResult result = tick(*world, desc, X);
      ASSERT_EQ(result.record.faults & kToolInside, 0u) << fit.name << " of size " << scale << " at " << i;
      if (i % every == 0)
        ASSERT_LE(judge.at(result.record.X_WT), kAsked) << fit.name << " of size " << scale << " at " << i;
    }
  }

private:
  double any(double most) { return std::uniform_real_distribution<double>(-most, most)(random_); }
  Vec3 in_cube(double half) { return {any(half), any(half), any(half)}; }

  std::mt19937_64 random_;
};

TEST(ExactContact, KeepsATinyPegOutOfTheWallsWhereTheHandLeaps) {
  const std::vector<Fit> all = fits();
  AnySize(1).leap_about(*std::ranges::find(all, "round peg 4 mm", &Fit::name), false, 0, 220, 1);
}

TEST(ExactContact, KeepsPartsOfAnySizeOutOfTheWallsWhereTheHandLeapsLong) {
  AnySize hand(2);
  for (const Fit& fit : fits()) {
    if (fit.name.starts_with("nut")) continue;
    hand.leap_about(fit, false, 0, 250, 15);
    hand.leap_about(fit, true, 0.3, 250, 15);
  }
}

TEST(ExactContact, AToolThatStartsInAWallIsLetOutAndSaysSo) {
  const std::vector<Fit> all = fits();
  const Fit& fit = *std::ranges::find(all, "square peg 4 mm", &Fit::name);
  SceneDesc desc = on_triangles(fit);
  desc.tool.X_WT_start.p += 50e-6 * fit.across_W;
  Result<World> world = World::build(desc);
  ASSERT_TRUE(world);
  EXPECT_NE(tick(*world, desc, desc.tool.X_WT_start).record.faults & kToolInside, 0u);
  StepResult result;
  for (int i = 0; i < 20; ++i) result = tick(*world, desc, {fit.X_WT.q, fit.X_WT.p + 8e-3 * fit.way_W});
  EXPECT_EQ(ExactDepth(fit.tool_T, fit.scene_W, 0.4e-3).at(result.record.X_WT), 0);
  EXPECT_GT((result.record.X_WT.p - fit.X_WT.p).dot(fit.way_W), 5e-3);
}

// Hands that are millimetres beyond what they push against: steps are long. In the first, each may go past
// the side of a thread that a chamfer has cut to nothing; in the second, a thread's end is over the other's
// at both ends of a step, and goes through it on the way.
TEST(ExactContact, KeepsANutOutOfTheBoltsEndThatItSlidesOver) {
  struct Leap {
    Pose X_from, X_to;
  };
  const std::vector<Leap> leaps{
      {{Quat(0.97866165862543752, -0.015877858289011136, 0.19750315365388482, 0.054422016219833565),
        Vec3(0.0029688889086174185, 0.00033506298792472977, 0.017502278964046242)},
       {Quat(0.97746545646107463, -0.015880277551412993, 0.20454639677040226, 0.049697784442349596),
        Vec3(-0.002770306117499143, 0.00019889431354345533, 0.012727757523297377)}},
      {{Quat(0.96525510298247741, -0.10367319625796952, 0.12462816350324622, 0.20494456666560271),
        Vec3(0.0012142258738516171, 0.0018727701852667424, 0.018388851274589765)},
       {Quat(0.96573721489950148, -0.10406798111689723, 0.12635737539586811, 0.20138346691691181),
        Vec3(0.00049713002298233297, 0.0013493362863326026, 0.017826437639462317)}}};
  constexpr content::MetricThread thread{.diameter = 12e-3, .pitch = 1.75e-3};
  const auto raised = [](TriangleMesh mesh, double z) {
    for (Vec3& p : mesh.vertices) p.z() += z;
    return mesh;
  };
  const content::LeadIn lead_in = content::LeadIn::chamfered;
  const TriangleMesh nut =
                         raised(mesh_of(content::threaded_nut(thread, 10.6e-3, 18e-3, lead_in, 48)), -5.3e-3),
                     bolt = raised(mesh_of(content::threaded_rod(thread, 21.6e-3, lead_in, 48)), -8e-3);
  SceneDesc desc = in_hand(nut, bolt);
  desc.contact.friction = 0.15;
  const ExactDepth judge(nut, bolt, 0.15e-3);
  for (std::size_t i = 0; i < leaps.size(); ++i) {
    desc.tool.X_WT_start = leaps[i].X_from;
    Result<World> world = World::build(desc);
    ASSERT_TRUE(world) << world.error().sentence;
    tick(*world, desc, leaps[i].X_from);
    for (int t = 0; t < 3; ++t) {
      const StepResult result = tick(*world, desc, leaps[i].X_to);
      EXPECT_EQ(result.record.faults & kToolInside, 0u) << i << ' ' << t;
      EXPECT_LE(judge.at(result.record.X_WT), 1e-6) << i << ' ' << t;
    }
  }
}

TEST(ExactContact, NeedsBothAndAConstraint) {
  const std::vector<Fit> all = fits();
  const Fit& fit = *std::ranges::find(all, "square peg 4 mm", &Fit::name);
  const SceneDesc good = on_triangles(fit);
  const auto refusal = [](const SceneDesc& desc) { return World::build(desc).error().sentence; };
  SceneDesc half = good, springs = good, points = good;
  half.tool_features = nullptr;
  EXPECT_NE(refusal(half).find("no pointshell"), std::string::npos) << refusal(half);
  points.tool_shell = std::make_shared<const Pointshell>(*bake_pointshell(*build_solid(fit.tool_T), {}));
  EXPECT_NE(refusal(points).find("both or neither"), std::string::npos) << refusal(points);
  points.scene_field = std::make_shared<const DistanceField>(*bake_field(*build_solid(fit.scene_W), {}));
  EXPECT_TRUE(World::build(points));
  half.tool_shell = points.tool_shell;
  half.scene_field = points.scene_field;
  EXPECT_NE(refusal(half).find("both or neither"), std::string::npos) << refusal(half);
  springs.contact.response = ContactResponse::penalty;
  EXPECT_NE(refusal(springs).find("the response constraint alone"), std::string::npos) << refusal(springs);
  SceneDesc edges = points, impacts = good;
  edges.scene_edges = points.tool_shell;
  edges.tool_field = points.scene_field;
  EXPECT_NE(refusal(edges).find("leave them out"), std::string::npos) << refusal(edges);
  impacts.impact_vibration.emplace();
  impacts.device.renders_force = true;
  EXPECT_NE(refusal(impacts).find("Impacts are told apart"), std::string::npos) << refusal(impacts);
}

// What nothing reads changes nothing.
TEST(ExactContact, IsTheSameWithPointsBesideIt) {
  const std::vector<Fit> all = fits();
  const Fit& fit = *std::ranges::find(all, "square peg 4 mm", &Fit::name);
  const SceneDesc without = on_triangles(fit);
  SceneDesc with = without;
  with.tool_shell = std::make_shared<const Pointshell>(*bake_pointshell(*build_solid(fit.tool_T), {}));
  with.scene_field = std::make_shared<const DistanceField>(*bake_field(*build_solid(fit.scene_W), {}));
  Result<World> a = World::build(without), b = World::build(with);
  ASSERT_TRUE(a && b);
  for (int i = 0; i < 100; ++i) {
    const Pose X{fit.X_WT.q, fit.X_WT.p + 1e-3 * std::sin(0.1 * i) * fit.across_W};
    const Pose here = tick(*a, without, X).record.X_WT, there = tick(*b, with, X).record.X_WT;
    ASSERT_TRUE(here.p == there.p && here.q.coeffs() == there.q.coeffs()) << i;
  }
}

}  // namespace
}  // namespace fulcrum::parts
