// Truths: the damped oscillator and the tumbling body of Euler's equations.

#include "haptics/tool/rigid_body.h"

#include <gtest/gtest.h>

#include <cmath>

#include "haptics/math/rotation.h"

namespace fulcrum {
namespace {

// x(.05 s) of m = .05, k = 1000, c = 2 from 1 mm at rest.
double oscillate(Integrator integrator, double tick) {
  const RigidBody body(0.05, Mat3::Identity());
  Linearisation around;
  around.K.topLeftCorner<3, 3>() = 1000 * Mat3::Identity();
  around.B.topLeftCorner<3, 3>() = 2 * Mat3::Identity();
  BodyState state;
  state.X_WT.p.x() = 1e-3;
  for (int i = 0; i < std::lround(0.05 / tick); ++i) {
    const Wrench F{-1000 * state.X_WT.p - 2 * state.V_WT.v, Vec3::Zero()};
    state.V_WT = integrator == Integrator::implicit_euler ? body.accelerate(state, F, around, tick)
                                                          : body.accelerate(state, F, tick);
    state.X_WT = RigidBody::advance(state.X_WT, state.V_WT, tick);
  }
  return state.X_WT.p.x();
}

TEST(RigidBody, BothIntegratorsAreOfOrderOne) {
  const double truth = 0.3118725489962e-3;
  for (Integrator integrator : {Integrator::semi_implicit_euler, Integrator::implicit_euler}) {
    const double coarse = std::abs(oscillate(integrator, 1e-4) - truth),
                 fine = std::abs(oscillate(integrator, 5e-5) - truth);
    EXPECT_NEAR(std::log2(coarse / fine), 1.0, 0.1) << static_cast<int>(integrator);
  }
}

// 4 m / T^2 is where semi-implicit Euler ends; implicit Euler has no end.
TEST(RigidBody, StiffnessLimitIsTheTheoretical) {
  const double tick = 1e-3, mass = 0.05, limit = 4 * mass / (tick * tick);
  const auto grows = [&](Integrator integrator, double k) {
    const RigidBody body(mass, Mat3::Identity());
    Linearisation around;
    around.K.topLeftCorner<3, 3>() = k * Mat3::Identity();
    BodyState state;
    state.X_WT.p.x() = 1e-3;
    for (int i = 0; i < 3000; ++i) {
      const Wrench F{-k * state.X_WT.p, Vec3::Zero()};
      state.V_WT = integrator == Integrator::implicit_euler ? body.accelerate(state, F, around, tick)
                                                            : body.accelerate(state, F, tick);
      state.X_WT = RigidBody::advance(state.X_WT, state.V_WT, tick);
    }
    return !(state.X_WT.p.norm() < 1.0);
  };
  EXPECT_FALSE(grows(Integrator::semi_implicit_euler, 0.99 * limit));
  EXPECT_TRUE(grows(Integrator::semi_implicit_euler, 1.01 * limit));
  for (double k : {1e-1, 1e3, 1e8}) EXPECT_FALSE(grows(Integrator::implicit_euler, k)) << k;
}

TEST(RigidBody, TumblingBodyKeepsItsMomentum) {
  Mat3 I = Mat3::Zero();
  I.diagonal() = Vec3(1, 2, 3);
  const RigidBody body(1, I);
  const auto drift = [&](double tick) {
    BodyState state;
    state.V_WT.w = Vec3(0.01, 1, 0.01);
    const Vec3 before = body.inertia_W(state.X_WT.q) * state.V_WT.w;
    for (int i = 0; i < std::lround(5 / tick); ++i) {
      state.V_WT = body.accelerate(state, {}, tick);
      state.X_WT = RigidBody::advance(state.X_WT, state.V_WT, tick);
    }
    return (body.inertia_W(state.X_WT.q) * state.V_WT.w - before).norm();
  };
  EXPECT_NEAR(std::log2(drift(1e-3) / drift(5e-4)), 1.0, 0.1);
}

BodyState spun(const Vec3& inertia, const Vec3& w, double seconds, double tick) {
  Mat3 I = Mat3::Zero();
  I.diagonal() = inertia;
  const RigidBody body(1, I);
  BodyState state;
  state.V_WT.w = w;
  for (int i = 0; i < std::lround(seconds / tick); ++i) {
    const RigidBody::Move move = body.accelerate_keeping_momentum(state, {}, tick);
    state.X_WT = RigidBody::advance(state.X_WT, move.during, tick);
    state.V_WT = move.after;
  }
  return state;
}

// Symmetric top I = (1, 1, 2), w = (.5, 0, 1): the pose after 10 s in closed form.
TEST(RigidBody, MomentumIntegratorIsOfOrderTwoInRotation) {
  const Quat truth(0.53869788, -0.05315610, 0.17969498, -0.82139439);
  const auto error = [&](double tick) {
    return rotation_vector(spun({1, 1, 2}, {0.5, 0, 1}, 10, tick).X_WT.q * truth.conjugate()).norm();
  };
  EXPECT_LT(error(1e-3), 1e-5);
  EXPECT_NEAR(std::log2(error(2e-2) / error(1e-2)), 2.0, 0.1);
}

// The middle axis: w2 of I = (1, 2, 3), w = (.01, 1, .01) first crosses zero at 10.91691349 s, body axes.
TEST(RigidBody, MomentumIntegratorFlipsATumblingBodyInTime) {
  const auto middle = [&](double seconds) {
    const BodyState state = spun({1, 2, 3}, {0.01, 1, 0.01}, seconds, 1e-3);
    return (state.X_WT.q.conjugate() * state.V_WT.w).y();
  };
  EXPECT_GT(middle(10.90), 0);
  EXPECT_LT(middle(10.93), 0);
}

}  // namespace
}  // namespace fulcrum
