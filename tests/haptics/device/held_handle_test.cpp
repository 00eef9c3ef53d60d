// A handle held on a lever, against the same equations by Runge and Kutta's rule in steps of 2 us, and
// against FrictionAxis where there is no lever.

#include "haptics/device/held_handle.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "haptics/device/friction_axis.h"
#include "haptics/math/rotation.h"

namespace fulcrum {
namespace {

HeldHandle::Figures stick_figures() {
  HeldHandle::Figures figures;
  figures.mass << Vec3::Constant(0.25), Vec3(5e-6, 1.7e-4, 1.7e-4);
  figures.damping << Vec3::Constant(0.75), Vec3(1e-4, 1.25e-3, 2e-3);
  figures.hand_mass = 0.2;
  figures.stiffness = 400;
  figures.hand_damping = 4;
  figures.angular_stiffness = 1;
  figures.angular_damping = 0.01;
  return figures;
}

// The reference: pose and velocity of the handle, the wrench of a point mass and springs at G written out.
struct Reference {
  HeldHandle::Figures f;
  Vec3 p_HG;
  Pose X;
  Vec3 v = Vec3::Zero(), w_A = Vec3::Zero();

  struct Rate {
    Vec3 v, w_D, dv, dw_A;
  };
  Rate rate(const Reference& at, const HeldHandle::Load& load, double t) const {
    const Mat3 R = at.X.q.toRotationMatrix();
    const Vec3 r = R * p_HG, w = R * at.w_A;
    const Quat q_wanted = quaternion_exp(load.V_wanted.w * t) * load.X_DH_wanted.q;
    const Vec3 p_wanted = load.X_DH_wanted.p + load.V_wanted.v * t + q_wanted * p_HG;
    const Vec3 v_wanted = load.V_wanted.v + load.V_wanted.w.cross(q_wanted * p_HG);
    const Vec3 f_G = f.stiffness * (p_wanted - at.X.p - r) + f.hand_damping * (v_wanted - at.v - w.cross(r));
    const Vec3 torque = f.angular_stiffness * rotation_vector(q_wanted * at.X.q.conjugate()) +
                        f.angular_damping * (load.V_wanted.w - w);
    Mat3 rx;
    rx << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
    // m dv + M (dv + dw x r + w x (w x r)) = F + f_G - b v;  I dw_A = R^T (tau + torque + r x (f_G - M a_G))
    // - b w
    const double m = f.mass[0], M = f.hand_mass;
    Mat6 A = Mat6::Zero();
    A.topLeftCorner<3, 3>() = (m + M) * Mat3::Identity();
    A.topRightCorner<3, 3>() = -M * rx * R;
    A.bottomLeftCorner<3, 3>() = M * R.transpose() * rx;
    A.bottomRightCorner<3, 3>() = Mat3(f.mass.tail<3>().asDiagonal()) - M * R.transpose() * rx * rx * R;
    const Vec3 outward = w.cross(w.cross(r));
    Vec6 b;
    b << load.F_H_D.force + f_G - f.damping[0] * at.v - M * outward,
        R.transpose() * (load.F_H_D.torque + torque + r.cross(f_G - M * outward)) -
            f.damping.tail<3>().cwiseProduct(at.w_A);
    const Vec6 d = A.fullPivLu().solve(b);
    return {at.v, w, d.head<3>(), d.tail<3>()};
  }
  Reference moved(const Rate& by, double h) const {
    Reference to = *this;
    to.X.p += h * by.v;
    to.X.q = (quaternion_exp(h * by.w_D) * X.q).normalized();
    to.v += h * by.dv;
    to.w_A += h * by.dw_A;
    return to;
  }
  void advance(const HeldHandle::Load& load, double tick_s, int steps) {
    const double h = tick_s / steps;
    for (int i = 0; i < steps; ++i) {
      const double t = i * h;
      const Rate a = rate(*this, load, t), b = rate(moved(a, h / 2), load, t + h / 2),
                 c = rate(moved(b, h / 2), load, t + h / 2), d = rate(moved(c, h), load, t + h);
      *this =
          moved({(a.v + 2 * b.v + 2 * c.v + d.v) / 6, (a.w_D + 2 * b.w_D + 2 * c.w_D + d.w_D) / 6,
                 (a.dv + 2 * b.dv + 2 * c.dv + d.dv) / 6, (a.dw_A + 2 * b.dw_A + 2 * c.dw_A + d.dw_A) / 6},
                h);
    }
  }
};

// A blow on the handle and a hand that moves on: the error is stated, and falls with the square of the tick's
// parts.
TEST(HeldHandle, FollowsTheExactMotion) {
  const HeldHandle::Figures figures = stick_figures();
  const Vec3 p_HG(0.1, 0, 0);
  HeldHandle held(figures, Pose{});
  Reference truth{figures, p_HG, Pose{}};
  HeldHandle::Load load;
  load.p_HG = p_HG;
  double error = 0, error_rad = 0, way = 0, turn = 0;
  for (int tick = 0; tick < 150; ++tick) {
    const double t = tick * 1e-3;
    load.F_H_D = {Vec3(0, tick < 20 ? 2.0 : 0.5, 0.3), Vec3(0.001, 0, tick < 20 ? 0.1 : 0)};
    load.X_DH_wanted.p = Vec3(0, -0.1 * t, 0);
    load.V_wanted.v = Vec3(0, -0.1, 0);
    held.advance(load, 1e-3);
    truth.advance(load, 1e-3, 500);
    error = std::max(error, (held.X_DH().p - truth.X.p).norm());
    error_rad = std::max(error_rad, rotation_vector(held.X_DH().q * truth.X.q.conjugate()).norm());
    way = std::max(way, truth.X.p.norm());
    turn = std::max(turn, rotation_vector(truth.X.q).norm());
  }
  EXPECT_GT(way, 5e-3);
  EXPECT_GT(turn, 0.03);
  EXPECT_LT(error, 5e-6);
  EXPECT_LT(error_rad, 5e-5);
}

TEST(HeldHandle, RestsWhereTheForcesBalance) {
  HeldHandle::Figures figures = stick_figures();
  figures.friction << Vec3::Constant(0.02), Vec3::Constant(5e-4);
  HeldHandle held(figures, Pose{});
  HeldHandle::Load load;
  load.p_HG = Vec3(0.07, 0, 0);
  load.F_H_D = {Vec3(0.1, 1, 0), Vec3(0, 0, 0.1)};
  for (int tick = 0; tick < 3000; ++tick) held.advance(load, 1e-3);
  const Pose before = held.X_DH();
  for (int tick = 0; tick < 100; ++tick) held.advance(load, 1e-3);
  EXPECT_NEAR((held.X_DH().p - before.p).norm(), 0, 1e-12);  // friction holds it, for good
  // What the hand feels is what pushes on the handle, at the hand, but for friction.
  const Vec3 lever = held.X_DH().q * load.p_HG;
  const Vec3 torque = load.F_H_D.torque - lever.cross(load.F_H_D.force);
  EXPECT_LE((held.felt().force - load.F_H_D.force).cwiseAbs().maxCoeff(), 0.02 + 1e-9);
  EXPECT_LE((held.felt().torque - torque).cwiseAbs().maxCoeff(), 5e-4 + 0.07 * 0.02 + 1e-9);
}

// f_h = f - m a: of the device's mass alone, whatever the hand's.
TEST(HeldHandle, TheHandFeelsTheHandlesInertia) {
  HeldHandle::Figures figures = stick_figures();
  figures.damping.setZero();
  HeldHandle held(figures, Pose{});
  HeldHandle::Load load;
  load.p_HG = Vec3(0.1, 0, 0);
  for (int tick = 0; tick < 200; ++tick) {
    const Vec3 v_before = held.velocity();
    load.F_H_D.force = Vec3(0, 1, 0.2);
    load.X_DH_wanted.p = Vec3(0, 2e-3 * std::sin(0.05 * tick), 0);
    held.advance(load, 1e-3);
    const Vec3 a = (held.velocity() - v_before) / 1e-3;
    EXPECT_NEAR((held.felt().force - (load.F_H_D.force - 0.25 * a)).norm(), 0, 1e-9) << tick;
  }
}

TEST(HeldHandle, KeepsTheEnergyOfASpring) {
  HeldHandle::Figures figures = stick_figures();
  figures.damping.setZero();
  figures.hand_damping = figures.angular_damping = 0;
  figures.hand_mass = 0;
  figures.angular_stiffness = 0;
  HeldHandle held(figures, Pose{});
  HeldHandle::Load load;
  held.push(Vec3(0, 0.1, 0));
  double least = 1, most = 0;
  for (int tick = 0; tick < 5000; ++tick) {
    held.advance(load, 1e-3);
    const double energy =
        0.5 * 0.25 * held.velocity().squaredNorm() + 0.5 * 400 * held.X_DH().p.squaredNorm();
    least = std::min(least, energy);
    most = std::max(most, energy);
  }
  EXPECT_NEAR(most, 0.5 * 0.25 * 0.01, 1e-9);
  EXPECT_NEAR(least, most, 1e-9);
}

// Without a lever each axis is FrictionAxis, which is exact: stick, slip and turning points.
TEST(HeldHandle, WithoutALeverIsAsFrictionAxisSays) {
  HeldHandle::Figures figures = stick_figures();
  figures.friction << Vec3::Constant(0.3), Vec3::Constant(5e-4);
  HeldHandle held(figures, Pose{});
  FrictionAxis axis{.mass = 0.45, .damping = 0.75, .friction = 0.3};
  double error = 0;
  for (int tick = 0; tick < 2000; ++tick) {
    const double t = tick * 1e-3, step = 2 * std::numbers::pi * 1.5;
    const double now = 3e-3 * std::sin(step * t), next = 3e-3 * std::sin(step * (t + 1e-3));
    HeldHandle::Load load;
    load.F_H_D.force.x() = 0.4 * std::sin(20 * t);
    load.X_DH_wanted.p.x() = now;
    load.V_wanted.v.x() = (next - now) / 1e-3;
    held.advance(load, 1e-3);
    axis.advance({.force = load.F_H_D.force.x(),
                  .stiffness = 400,
                  .hand_damping = 4,
                  .hand_x = now,
                  .hand_v = load.V_wanted.v.x()},
                 1e-3);
    error = std::max(error, std::abs(held.X_DH().p.x() - axis.x));
  }
  EXPECT_LT(error, 2e-6);
}

}  // namespace
}  // namespace fulcrum
