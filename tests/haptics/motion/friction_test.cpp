// Coulomb friction under the responses that have it, against statics: a probe, a twisted stand, one point
// that is spun and rolled. A constraint holds a point to rounding; springs give way by what they are
// stretched.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "haptics/contact/region_friction.h"
#include "haptics/math/rotation.h"
#include "tests/haptics/scenes.h"

namespace fulcrum::test {
namespace {

constexpr double kPull = 800, kTurn = 0.1;  // N/m and N m/rad, of the coupling
constexpr double kSprings = 2e4;            // N/m, of a region
constexpr double kLate = 2 * kTurn * 3e-4;  // N m: the hand turns by that in two ticks

class Friction : public testing::TestWithParam<ContactResponse> {
protected:
  static Pose above_floor(double y) { return {Quat::Identity(), Vec3(0, y, 0)}; }

  // Springs far below their saturation, so that they are linear to a thousandth.
  SceneDesc scene(const std::vector<Vec3>& points) const {
    SceneDesc desc = floor_scene(points, 0.02);
    desc.contact.response = GetParam();
    desc.contact.stiffness = kSprings;
    desc.mapping.force_scale = 1;
    desc.coupling = {.stiffness = kPull,
                     .angular_stiffness = kTurn,
                     .damping_ratio = has_mass() ? 1.0 : 0.0,
                     .max_force = 5000,
                     .max_torque = 500};
    return desc;
  }
  static bool is_constraint() { return GetParam() == ContactResponse::constraint; }
  bool has_mass() const { return !massless(GetParam()); }
  // m: what springs may be stretched by under F, N.
  double give(double F) const {
    return GetParam() == ContactResponse::constraint ? 1e-6
                                                     : F / (RegionFriction::kAlong * kSprings) * 1.15 + 1e-6;
  }
  static std::vector<Vec3> feet(double r) {
    std::vector<Vec3> feet;
    for (int i = 0; i < 3; ++i) {
      const double angle = 2 * std::numbers::pi * i / 3;
      feet.emplace_back(r * std::cos(angle), 0, r * std::sin(angle));
    }
    return feet;
  }
};

// What holds a probe back along the surface is the friction of the force that pushes it, and no more.
TEST_P(Friction, HoldsAProbeUpToItsCone) {
  for (const double coefficient : {0.1, 0.4, 1.0}) {
    SceneDesc desc = scene({Vec3::Zero()});
    desc.contact.friction = coefficient;
    World world = expect(World::build(desc));
    const double depth = 3e-3;
    const double load = hold(world, above_floor(-depth), 800).record.contact_F_T_W.force.y();
    EXPECT_NEAR(load, kPull * depth, (is_constraint() ? 0.01 : 0.05) * kPull * depth);
    const double cone = coefficient * load / kPull;  // m of the coupling's offset
    const auto drag = [&](double x, double z) {
      return step(world, at({Quat::Identity(), Vec3(x, -depth, z)}), {}).record;
    };
    TickRecord record;
    for (int i = 1; i <= 100; ++i) record = drag(0.9e-2 * cone * i, 0);
    for (int i = 0; i < 200; ++i) record = drag(0.9 * cone, 0);
    const double stuck = record.X_WT.p.x();
    EXPECT_LT(stuck, give(0.9 * coefficient * load)) << "it sticks";
    for (int i = 0; i < 5000; ++i) record = drag(0.9 * cone, 0);
    EXPECT_NEAR(record.X_WT.p.x(), stuck, 1e-7) << "it does not creep";
    EXPECT_NEAR(record.coupling_F_T_W.force.x(), kPull * (0.9 * cone - stuck), 0.01 * kPull * cone);
    for (int i = 1; i <= 1200; ++i) record = drag(0.9 * cone + 1e-2 * cone * i, 1e-2 * cone * i);
    const Vec3 F = record.contact_F_T_W.force;
    EXPECT_NEAR(std::hypot(F.x(), F.z()), coefficient * F.y(), 0.01 * coefficient * F.y()) << "it slides";
    EXPECT_NEAR(F.z() / F.x(), 1, 0.01) << "and is held against the motion";
    EXPECT_NEAR(F.y(), load, 0.01 * load) << "and pushed as before";
    if (is_constraint()) EXPECT_NEAR(record.X_WT.p.y(), 0, 2e-6);
  }
}

// Pulled at a slant, as a load on a slope pulls: below atan(mu) it stays for good.
TEST_P(Friction, HoldsUnderASlantedLoadUpToItsAngle) {
  constexpr double coefficient = 0.3, depth = 3e-3;
  for (const double degrees : {5.0, 15.0, 16.0, 17.5, 25.0}) {
    SceneDesc desc = scene({Vec3::Zero()});
    desc.contact.friction = coefficient;
    World world = expect(World::build(desc));
    hold(world, above_floor(0), 400);
    const double angle = degrees * std::numbers::pi / 180, down = depth * std::cos(angle),
                 along = depth * std::sin(angle);
    TickRecord record;
    for (int i = 1; i <= 4000; ++i) {
      const double part = std::min(1.0, i / 400.0);
      record = step(world, at({Quat::Identity(), Vec3(part * along, -part * down, 0)}), {}).record;
    }
    const Vec3 F = record.contact_F_T_W.force;
    const double slid = record.X_WT.p.x(), truth = along - coefficient * F.y() / kPull;
    EXPECT_NEAR(slid, std::max(0.0, truth), give(coefficient * F.y()) + 0.01 * along) << degrees;
    EXPECT_LE(std::hypot(F.x(), F.z()), coefficient * F.y() * 1.002) << degrees;
  }
}

// Three feet under a load, twisted: each gives its cone at its radius; near each other they are one region,
// whose spread tells of it.
TEST_P(Friction, HoldsATwist) {
  constexpr double depth = 3e-3, coefficient = 0.3;
  for (const double r : {0.004, 0.02}) {
    SceneDesc desc = scene(feet(r));
    desc.contact.friction = coefficient;
    World world = expect(World::build(desc));
    const double load = hold(world, above_floor(-depth), 800).record.contact_F_T_W.force.y();
    const double most = coefficient * load * r;  // N m
    StepResult result;
    for (int i = 1; i <= 1000; ++i) {
      const double angle = 3e-4 * i;
      result = step(world, at({quaternion_exp(Vec3(0, angle, 0)), Vec3(0, -depth, 0)}), {});
      const double torque = -result.record.contact_F_T_W.torque.y();
      ASSERT_LT(torque, 1.1 * most + kLate) << i;
      if (is_constraint()) EXPECT_NEAR(torque, std::min(most, kTurn * angle), 0.01 * most) << r << ' ' << i;
    }
    EXPECT_NEAR(result.record.contact_F_T_W.torque.y(), -most, 0.02 * most) << r;
    EXPECT_NEAR(result.record.X_WT.p.x(), 0, is_constraint() ? 2e-6 : 5e-6);
  }
}

// One point has no extent: what is named against spinning and rolling holds it, and no more.
TEST_P(Friction, HoldsAPointThatIsSpunOrRolledUpToItsLength) {
  constexpr double depth = 3e-3, torsional = 2e-3, rolling = 0.5e-3;
  for (const Vec3& axis : {Vec3(0, 1, 0), Vec3(1, 0, 0)}) {
    SceneDesc desc = scene({Vec3::Zero(), Vec3(0, 0.03, 0)});
    desc.contact.friction = 0.5;
    desc.contact.torsional_friction = torsional;
    desc.contact.rolling_friction = rolling;
    World world = expect(World::build(desc));
    const double load = hold(world, above_floor(-depth), 800).record.contact_F_T_W.force.y();
    const double most = (axis.y() > 0 ? torsional : rolling) * load;
    StepResult result;
    for (int i = 1; i <= 1000; ++i) {
      const double angle = 3e-4 * i;
      result = step(world, at({quaternion_exp(angle * axis), Vec3(0, -depth, 0)}), {});
      ASSERT_LT(-result.record.contact_F_T_W.torque.dot(axis), 1.1 * most + kLate) << i;
    }
    EXPECT_NEAR(result.record.contact_F_T_W.torque.dot(axis), -most, 0.02 * most);
  }
}

// A plate of many points is dragged, tipped onto an edge and lifted: who pushes changes all the time, and
// with it what is remembered of them.
TEST_P(Friction, StaysInItsConeWhileContactsComeAndGo) {
  std::vector<Vec3> plate;
  for (int i = -7; i <= 7; ++i)
    for (int j = -7; j <= 7; ++j) plate.emplace_back(2e-3 * i, 0, 2e-3 * j);
  SceneDesc desc = scene(plate);
  desc.contact.friction = 0.5;
  World world = expect(World::build(desc));
  hold(world, above_floor(-1e-3), 800);
  int rubbing = 0;
  for (int i = 0; i < 1200; ++i) {
    const double tip = 0.2 * std::sin(0.02 * i), y = -1e-3 + 2e-3 * std::sin(0.013 * i);
    const Pose X_WH{quaternion_exp(Vec3(tip, 0.1 * std::sin(0.007 * i), 0.5 * tip)),
                    Vec3(5e-3 * std::sin(0.01 * i), y, 5e-3 * std::sin(0.017 * i))};
    const Vec3 F = step(world, at(X_WH), {}).record.contact_F_T_W.force;
    const double across = std::hypot(F.x(), F.z());
    ASSERT_LE(across, 0.5 * F.y() * 1.02 + 2e-3) << i;
    rubbing += across > 0.1 * F.y() ? 1 : 0;
  }
  EXPECT_GT(rubbing, 200);
}

// However stiff the contact: a stand that is thrown at the floor comes to rest there, in balance.
TEST_P(Friction, StaysStableWhateverPresses) {
  for (const double stiffness : {1e3, 1e5, 1e7})
    for (const double coefficient : {0.2, 5.0})
      for (const Integrator integrator : {Integrator::semi_implicit_euler, Integrator::implicit_euler}) {
        if (integrator == Integrator::implicit_euler && !has_mass()) continue;
        SceneDesc desc = scene(feet(0.02));
        desc.contact.stiffness = stiffness;
        desc.contact.friction = coefficient;
        desc.contact.torsional_friction = desc.contact.rolling_friction = 1e-3;
        desc.integrator = integrator;
        World world = expect(World::build(desc));
        hold(world, above_floor(0.01), 200);
        // Thrown at the floor at a slant, 2 m/s, and then held in it.
        TickRecord record;
        for (int i = 0; i < 2000; ++i) {
          const double part = std::min(1.0, i / 10.0);
          const Pose X_WH{quaternion_exp(part * Vec3(0.2, 0.5, -0.1)),
                          Vec3(0.01 * part, 0.01 - 0.02 * part, 0)};
          record = step(world, at(X_WH), {}).record;
          ASSERT_TRUE(record.X_WT.is_finite());
          ASSERT_LT(record.X_WT.p.norm(), 0.05) << i;
        }
        const Pose X_WT = record.X_WT;
        for (int i = 0; i < 500; ++i)
          record = step(world, at({quaternion_exp(Vec3(0.2, 0.5, -0.1)), Vec3(0.01, -0.01, 0)}), {}).record;
        EXPECT_LT((record.X_WT.p - X_WT.p).norm(), 1e-6) << stiffness << ' ' << coefficient;
        EXPECT_LT((record.contact_F_T_W.force + record.coupling_F_T_W.force).norm(), 0.1)
            << stiffness << ' ' << coefficient << ": it is in balance";
        EXPECT_LT(angle_between(record.X_WT.q, X_WT.q), 1e-4) << stiffness << ' ' << coefficient;
      }
}

// Nothing else damps a tool with mass that sticks, if its coupling does not.
TEST(FrictionOfAToolWithMass, SticksWithoutRinging) {
  SceneDesc desc = floor_scene({Vec3::Zero()}, 0.02);
  desc.mapping.force_scale = 1;
  desc.coupling.max_force = 5000;
  desc.coupling.damping_ratio = 0;
  desc.contact.friction = 1;
  desc.contact.dissipation = 1000;
  World world = expect(World::build(desc));
  hold(world, {Quat::Identity(), Vec3(0, -3e-3, 0)}, 3000);
  double least = 1, most = -1;
  for (int i = 0; i < 600; ++i) {
    const double x = step(world, at({Quat::Identity(), Vec3(1e-3, -3e-3, 0)}), {}).record.X_WT.p.x();
    if (i < 500) continue;
    least = std::min(least, x);
    most = std::max(most, x);
  }
  EXPECT_GT(least, 1e-6);
  EXPECT_LT(most - least, 0.01 * most);
}

INSTANTIATE_TEST_SUITE_P(Responses, Friction,
                         testing::Values(ContactResponse::constraint, ContactResponse::quasi_static,
                                         ContactResponse::penalty),
                         [](const auto& response) { return std::string(name_of(response.param)); });

TEST(FrictionScene, IsRefusedWhereTheToolIsWhereTheHandIs) {
  SceneDesc desc = floor_scene({Vec3::Zero()}, 0.02);
  desc.contact.response = ContactResponse::direct;
  desc.contact.rolling_friction = 1e-3;
  const Result<World> world = World::build(desc);
  ASSERT_FALSE(world);
  EXPECT_NE(world.error().sentence.find("name another"), std::string::npos) << world.error().sentence;
}

}  // namespace
}  // namespace fulcrum::test
