// The coupling's spring at the point where the hand holds the tool.

#include <gtest/gtest.h>

#include <cmath>

#include "haptics/math/rotation.h"
#include "haptics/tool/virtual_coupling.h"

namespace fulcrum {
namespace {

const CouplingDesc kDesc{
    .stiffness = 800, .angular_stiffness = 0.5, .damping_ratio = 0.7, .max_force = 6, .max_torque = 0.3};
const Vec3 kGrip(0.08, 0.01, -0.02);

RigidBody stick() {
  return {0.05, Vec3(2e-5, 7e-5, 6e-5).asDiagonal()};
}

BodyState moving() {
  return {{quaternion_exp({0.1, 0.2, -0.3}), {0.01, 0.02, 0.03}}, {{0.1, -0.2, 0.05}, {0.5, -1, 2}}};
}

const Pose kWanted{quaternion_exp({0.15, 0.18, -0.33}), {0.012, 0.019, 0.031}};
const Twist kWantedV{{0.05, 0.02, 0}, {0.1, 0.2, -0.4}};

VirtualCoupling held(const Vec3& p_TG) {
  VirtualCoupling coupling(kDesc, stick(), kGrip);
  coupling.hold_at(p_TG);
  return coupling;
}

// A hand that turns the tool about G stretches no spring of force: the torque alone turns it.
TEST(CouplingAtTheGrip, ATurnAboutTheGripIsNoForce) {
  VirtualCoupling coupling = held(kGrip);
  BodyState tool;
  Pose X_WG{quaternion_exp({0, 0, 0.05}), {}};
  X_WG.p = kGrip - X_WG.q * kGrip;  // G stays
  const Wrench F = coupling.pull(X_WG, {}, tool);
  EXPECT_NEAR(F.force.norm(), 0, 1e-12);
  EXPECT_NEAR(F.torque.z(), 0.3 * (1 - std::exp(-0.5 * 0.05 / 0.3)), 1e-12);
}

// The same force at G, as a wrench about T.
TEST(CouplingAtTheGrip, PullsAtTheGrip) {
  VirtualCoupling coupling = held(kGrip);
  BodyState tool;
  const Wrench F = coupling.pull({Quat::Identity(), {0, 1e-3, 0}}, {}, tool);
  EXPECT_NEAR((F.force - Vec3(0, 6 * (1 - std::exp(-0.8 / 6)), 0)).norm(), 0, 1e-12);
  EXPECT_NEAR((F.torque - kGrip.cross(F.force)).norm(), 0, 1e-15);
  EXPECT_EQ(coupling.full_torque(), F.torque);
}

// The springs' wrench is minus the gradient of their energy.
TEST(CouplingAtTheGrip, SpringsAreTheGradientOfTheirEnergy) {
  VirtualCoupling coupling = held(kGrip);
  BodyState at = moving();
  at.V_WT = {};
  const Wrench F = coupling.pull(kWanted, {}, at);
  Vec6 force;
  force << F.force, F.torque;
  constexpr double h = 1e-6;
  for (int i = 0; i < 6; ++i) {
    const auto energy = [&](double d) {
      Vec6 step = Vec6::Zero();
      step[i] = d;
      BodyState moved = at;
      moved.X_WT = RigidBody::advance(at.X_WT, {step.head<3>(), step.tail<3>()}, 1.0);
      coupling.pull(kWanted, {}, moved);
      return coupling.stored();
    };
    // In rotation the spring is along the rotation vector, the gradient to first order in its angle.
    EXPECT_NEAR(-(energy(h) - energy(-h)) / (2 * h), force[i], i < 3 ? 1e-6 : 2e-3) << i;
  }
}

TEST(CouplingAtTheGrip, DampersTakeEnergyAlways) {
  VirtualCoupling coupling = held(kGrip);
  const BodyState tool = moving();
  const Wrench moving_F = coupling.pull(kWanted, kWantedV, tool);
  BodyState still = tool;
  still.V_WT = {};
  const Wrench still_F = coupling.pull(kWanted, {}, still);
  const Wrench by_damper = moving_F + -still_F;
  const Vec3 w = tool.V_WT.w - kWantedV.w;
  const Vec3 r = tool.X_WT.q * kGrip, wanted_r = kWanted.q * kGrip;
  const Vec3 v_G = tool.V_WT.v + tool.V_WT.w.cross(r) - kWantedV.v - kWantedV.w.cross(wanted_r);
  const Vec3 torque_G = by_damper.torque - r.cross(by_damper.force);
  EXPECT_LT(by_damper.force.dot(v_G), 0);
  EXPECT_LT(torque_G.dot(w), 0);
  EXPECT_NEAR(by_damper.force.cross(v_G).norm(), 0, 1e-12);
}

// Linearised about a small stretch it is the derivative of pull().
TEST(CouplingAtTheGrip, LinearisationIsTheDerivative) {
  VirtualCoupling coupling = held(kGrip);
  BodyState tool;
  tool.X_WT.q = quaternion_exp({0.3, -0.2, 0.1});
  const Pose X_WG = tool.X_WT;
  coupling.pull(X_WG, {}, tool);
  Linearisation around;
  coupling.linearise(tool, around);
  constexpr double h = 1e-8;  // or the springs' saturation shows
  for (int i = 0; i < 6; ++i) {
    Vec6 step = Vec6::Zero();
    step[i] = h;
    BodyState moved = tool;
    moved.X_WT = RigidBody::advance(tool.X_WT, {step.head<3>(), step.tail<3>()}, 1.0);
    const Wrench by_place = coupling.pull(X_WG, {}, moved);
    BodyState faster = tool;
    faster.V_WT = {step.head<3>(), step.tail<3>()};
    const Wrench by_speed = coupling.pull(X_WG, {}, faster);
    Vec6 K, B;
    K << by_place.force, by_place.torque;
    B << by_speed.force, by_speed.torque;
    EXPECT_NEAR((K / h + around.K.col(i)).norm(), 0, 1e-3) << i;
    EXPECT_NEAR((B / h + around.B.col(i)).norm(), 0, 1e-4) << i;
  }
}

TEST(CouplingAtTheGrip, AtTheCentreOfMassItIsTheCouplingThatWas) {
  VirtualCoupling plain(kDesc, stick()), at_T(kDesc, stick(), Vec3::Zero());
  at_T.hold_at(Vec3::Zero());
  const Wrench a = plain.pull(kWanted, kWantedV, moving()), b = at_T.pull(kWanted, kWantedV, moving());
  EXPECT_NEAR((a.force - b.force).norm(), 0, 1e-12);
  EXPECT_NEAR((a.torque - b.torque).norm(), 0, 1e-14);
  EXPECT_EQ(plain.stored(), at_T.stored());
}

// By the energy of a blow: of all directions of a unit impulse at p, the one that gives most speed there.
TEST(CouplingAtTheGrip, LeastMassIsTheSlowestDirections) {
  const RigidBody body = stick();
  double most = 0;
  const Mat3 inverse = body.inverse_inertia_W(Quat::Identity());
  for (int i = 0; i < 40; ++i) {
    for (int j = 0; j < 80; ++j) {
      const double a = i * 3.14159265 / 40, b = j * 3.14159265 / 40;
      const Vec3 n(std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a));
      const Vec3 arm = kGrip.cross(n);
      most = std::max(most, 1 / body.mass() + arm.dot(inverse * arm));
    }
  }
  EXPECT_NEAR(1 / most, body.least_mass_at(kGrip), 0.003 * body.least_mass_at(kGrip));
  EXPECT_LE(body.least_mass_at(kGrip), 1 / most * (1 + 1e-12));
}

}  // namespace
}  // namespace fulcrum
