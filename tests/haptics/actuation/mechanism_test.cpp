#include "haptics/actuation/mechanism.h"

#include <gtest/gtest.h>

#include "haptics/actuation/actuators.h"
#include "haptics/math/rotation.h"
#include "haptics/math/split_mix.h"
#include "tests/haptics/actuation/arms.h"
#include "tests/haptics/actuation/w6d.h"

namespace fulcrum {
namespace {

Pose random_pose(SplitMix& random, double far, double turn) {
  const Vec3 p = far * arms::random_vector(random);
  return {quaternion_exp(turn * arms::random_vector(random)), p};
}

TEST(Mechanism, ArmsOfTheW6DEndWhereThePaperSaysAtItsNominalPose) {
  const Mechanism mechanism(w6d::device(0.511, 0.145).mechanism);
  const Vec3 lower = mechanism.placed(0).X_DE.p, upper = mechanism.placed(1).X_DE.p;
  EXPECT_NEAR((1e3 * w6d::end_K(0, w6d::kNominal0) - Vec3(205.724, -24.755, 190.270)).norm(), 0, 1e-3);
  EXPECT_NEAR((1e3 * w6d::end_K(1, w6d::kNominal1) - Vec3(205.701, -63.928, 151.077)).norm(), 0, 1e-3);
  EXPECT_NEAR(lower.norm(), 0, 1e-12);
  EXPECT_NEAR((upper - lower - (w6d::end_K(0, w6d::kNominal0) - w6d::end_K(1, w6d::kNominal1))).norm(), 0,
              1e-12);
  EXPECT_NEAR(1e3 * (upper - lower).norm(), 55.414, 1e-3);
}

// Both arms stay at the stylus wherever it goes, and come back to the angles that they had.
TEST(Mechanism, TheLoopStaysClosed) {
  Mechanism mechanism(w6d::device(0.511, 0.145).mechanism);
  const JointAngles home = mechanism.angles(1);
  const Vec3 upper_H = mechanism.placed(1).X_DE.p;
  SplitMix random(7);
  int reached = 0;
  for (int i = 0; i < 1000; ++i) {
    const Pose X_DH = random_pose(random, 0.05, 0.4);
    mechanism.follow(X_DH);
    if (mechanism.out_of_reach() > 1e-9) continue;  // the stops are in the way
    ++reached;
    EXPECT_NEAR((mechanism.placed(0).X_DE.p - X_DH.p).norm(), 0, 1e-9);
    EXPECT_NEAR((mechanism.placed(1).X_DE.p - X_DH * upper_H).norm(), 0, 1e-9);
  }
  EXPECT_GT(reached, 900);
  mechanism.follow(Pose{});
  for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(mechanism.angles(1)[j], home[j], 1e-9);
}

// Against Eq. 26 from formulas of its own: the arms' ends as the paper writes them, differences for B.
TEST(Mechanism, WrenchesOfTheW6DAreItsInverseJacobianTransposed) {
  Mechanism mechanism(w6d::device(0.511, 0.145).mechanism);
  SplitMix random(3);
  for (int i = 0; i < 200; ++i) {
    mechanism.follow(random_pose(random, 0.04, 0.3));
    if (mechanism.out_of_reach() > 1e-9) continue;
    const JointAngles &lower = mechanism.angles(0), &upper = mechanism.angles(1);
    const Eigen::Matrix<double, 7, 6> J_ik =
        w6d::inverse_jacobian_K({upper[1], upper[2], upper[0]}, {lower[1], lower[2], lower[0]});
    constexpr int rows[] = {5, 3, 4, 2, 0, 1, 6};  // of the motors in the table's order
    for (int motor = 0; motor < 7; ++motor) {
      const Vec6 expected = J_ik.row(rows[motor]).transpose();
      EXPECT_NEAR((mechanism.wrenches().col(motor) - expected).norm() / expected.norm(), 0, 1e-7)
          << "motor " << motor;
    }
    EXPECT_TRUE(mechanism.wrenches().col(7).isZero(0));
  }
}

// Virtual work: a motor's torque times what it turns is what its wrench does to the handle. The angles come
// from moving the handle a little to each side; a parallelogram's motor turns by both angles.
TEST(Mechanism, WrenchesOfAnyTableAreTheDifferencesOfItsAngles) {
  for (const MechanismDesc& table : {w6d::device(1, 1).mechanism, arms::serial6().mechanism,
                                     arms::freedom6s().mechanism, arms::phantom().mechanism}) {
    Mechanism at(table);
    SplitMix random(11);
    int checked = 0;
    for (int i = 0; i < 100; ++i) {
      const Pose X_DH = random_pose(random, 0.04, 0.3);
      at.follow(X_DH);
      if (at.out_of_reach() > 1e-9) continue;
      ++checked;
      const WrenchMatrix wrenches = at.wrenches();
      constexpr double h = 1e-6;
      for (int axis = 0; axis < 6; ++axis) {
        std::vector<double> rates;
        Mechanism more = at, less = at;
        Pose ahead = X_DH, behind = X_DH;
        if (axis < 3) {
          ahead.p[axis] += h;
          behind.p[axis] -= h;
        } else {
          ahead.q = quaternion_exp(h * Vec3::Unit(axis - 3)) * ahead.q;
          behind.q = quaternion_exp(-h * Vec3::Unit(axis - 3)) * behind.q;
        }
        more.follow(ahead);
        less.follow(behind);
        for (std::size_t arm = 0; arm < table.arms.size(); ++arm) {
          double before = 0;
          for (std::size_t j = 0; j < table.arms[arm].joints.size(); ++j) {
            const int index = static_cast<int>(arm);
            const double rate = (more.angles(index)[j] - less.angles(index)[j]) / (2 * h);
            rates.push_back(table.arms[arm].joints[j].through_parallelogram ? before + rate : rate);
            before = rate;
          }
        }
        for (std::size_t motor = 0; motor < rates.size(); ++motor)
          EXPECT_NEAR(wrenches(axis, static_cast<Eigen::Index>(motor)), rates[motor],
                      1e-5 * std::max(1.0, std::abs(rates[motor])))
              << "axis " << axis << " motor " << motor;
      }
    }
    EXPECT_GT(checked, 50);
  }
}

// The wrist of Eq. 2 of "Compensating device inertia", with the minus that its sixth row has lost: yaw, pitch
// and roll at the stage's centre, the control point a along the stick. (6 x 3)
Eigen::Matrix<double, 6, 3> wrist(double a, double theta4, double theta5) {
  const double c4 = std::cos(theta4), s4 = std::sin(theta4), c5 = std::cos(theta5), s5 = std::sin(theta5);
  Eigen::Matrix<double, 6, 3> J;
  J << 0, 0, 0,                  //
      -a * c5 * s4, a * c4, 0,   //
      -a * c5 * c4, -a * s4, 0,  //
      s5, 0, 1,                  //
      c5 * c4, s4, 0,            //
      -c5 * s4, c4, 0;
  return J;
}

TEST(Mechanism, TheWristOfTheFreedom6SIsThePapers) {
  Mechanism mechanism(arms::freedom6s().mechanism);
  SplitMix random(13);
  for (int i = 0; i < 200; ++i) {
    const Pose X_DH = random_pose(random, 0.05, 0.5);
    mechanism.follow(X_DH);
    ASSERT_LT(mechanism.out_of_reach(), 1e-9);
    const double theta5 = mechanism.angles(0)[4], theta4 = mechanism.angles(0)[5];
    for (const double a : {0.0, 0.05, 0.17}) {
      const WrenchMatrix J = mechanism.jacobian({a, 0, 0});
      EXPECT_LT((J.middleCols<3>(3) - wrist(a, theta4, theta5)).norm(), 1e-9);
      for (int motor = 3; motor < 6; ++motor) {
        const Vec3 v = J.col(motor).head<3>(), w = J.col(motor).tail<3>();
        EXPECT_LT((v - Vec3(0, a * w.z(), -a * w.y())).norm(), 1e-12);
      }
      const Mat3 turns = J.block<3, 3>(3, 3);
      EXPECT_NEAR(std::abs(turns.determinant()), std::cos(theta5), 1e-9);
    }
  }
}

// Eq. 1: what the hand feels where the control point is not where it holds.
TEST(Mechanism, AWrongControlPointIsFeltAsTheJacobiansSay) {
  Mechanism mechanism(arms::freedom6s().mechanism);
  SplitMix random(17);
  for (int i = 0; i < 100; ++i) {
    const Pose X_DH = random_pose(random, 0.05, 0.5);
    mechanism.follow(X_DH);
    const Vec3 p_HU(0.2 * random.uniform(), 0, 0), p_HG(0.2 * random.uniform(), 0, 0);  // used; true
    const Vec3 f_H = arms::random_vector(random), tau_H = 0.1 * arms::random_vector(random);
    Vec6 F;
    F << f_H, tau_H;
    const Effort effort = mechanism.jacobian(p_HU).transpose() * F;
    const Eigen::Matrix<double, 6, 6> J_true = mechanism.jacobian(p_HG).leftCols<6>();
    const Vec6 felt = J_true.transpose().partialPivLu().solve(effort.head<6>());
    EXPECT_LT((felt.head<3>() - f_H).norm(), 1e-11);
    EXPECT_LT((felt.tail<3>() - (tau_H + (p_HU - p_HG).cross(f_H))).norm(), 1e-11);
    // The motors' wrench on the handle is the same, moved.
    const Vec6 on_handle = mechanism.wrenches() * effort;
    EXPECT_LT((X_DH.q.conjugate() * on_handle.head<3>() - f_H).norm(), 1e-9);
    EXPECT_LT((X_DH.q.conjugate() * on_handle.tail<3>() - (tau_H + p_HU.cross(f_H))).norm(), 1e-9);
  }
}

TEST(Mechanism, StretchedFoldedAndOutOfReachWrenchesAreFinite) {
  for (const MechanismDesc& table : {w6d::device(1, 1).mechanism, arms::serial6().mechanism,
                                     arms::freedom6s().mechanism, arms::phantom().mechanism}) {
    Mechanism mechanism(table);
    SplitMix random(5);
    for (int i = 0; i < 300; ++i) {
      mechanism.follow(random_pose(random, i % 3 == 0 ? 5.0 : 0.5, 3));
      EXPECT_TRUE(mechanism.wrenches().allFinite());
      EXPECT_LE(mechanism.wrenches().topRows<3>().colwise().norm().maxCoeff(), 1.001 / Mechanism::kMinLever);
    }
  }
}

// The handle pulled out until the elbow is at its stop, just before the arm is straight, beyond, and back:
// the way in which the wrenches change has no jump in it.
TEST(Mechanism, GoesToItsStopAndBackWithoutAJump) {
  Mechanism mechanism(arms::phantom().mechanism);
  WrenchMatrix last = mechanism.wrenches();
  double largest = 0;
  for (int i = 0; i <= 4000; ++i) {
    const double out = 0.2 * std::sin(std::numbers::pi * i / 4000);
    mechanism.follow({Quat::Identity(), Vec3(0, 0.3 * out, out)});
    largest = std::max(largest, (mechanism.wrenches() - last).norm() * Mechanism::kMinLever);
    last = mechanism.wrenches();
  }
  EXPECT_LT(largest, 0.1);  // of the largest that there is
}

TEST(Mechanism, MotorsHaveTheTablesNamesAndLimits) {
  const DeviceDesc desc = w6d::device(0.511, 0.145);
  EXPECT_EQ(Actuators::count(desc), 7);
  EXPECT_EQ(Actuators::name(desc, 0), "lower_yaw");
  EXPECT_EQ(Actuators::name(desc, 4), "upper_shoulder");
  EXPECT_EQ(Actuators::name(desc, 6), "twist");
  EXPECT_EQ(Actuators(desc).limits()[5], 0.511);
  EXPECT_EQ(Actuators(desc).limits()[6], 0.145);
  EXPECT_EQ(Actuators::count(arms::phantom()), 3);
  EXPECT_EQ(Actuators::count(arms::serial6()), 6);
}

TEST(Mechanism, RefusesTablesThatAreNoDevice) {
  const MechanismDesc good = w6d::device(1, 1).mechanism;
  EXPECT_FALSE(Mechanism::refuse(good));
  const auto refused = [&good](const auto& spoil) {
    MechanismDesc bad = good;
    spoil(bad);
    const auto error = Mechanism::refuse(bad);
    return error ? error->sentence : "";
  };
  EXPECT_NE(refused([](auto& d) { d.arms.clear(); }).find("one arm or two"), std::string::npos);
  EXPECT_NE(refused([](auto& d) { d.arms[1].joints.pop_back(); }).find("three joints"), std::string::npos);
  EXPECT_NE(refused([](auto& d) { d.arms[0].joints[1].axis_K.setZero(); }).find("no axis"),
            std::string::npos);
  EXPECT_NE(refused([](auto& d) { d.arms[0].joints[1].home = 3; }).find("stops"), std::string::npos);
  EXPECT_NE(refused([](auto& d) { d.arms[0].joints[0].through_parallelogram = true; }).find("first"),
            std::string::npos);
  EXPECT_NE(refused([](auto& d) { d.arms.pop_back(); }).find("two arms"), std::string::npos);
  EXPECT_NE(refused([](auto& d) { d.arms[1] = d.arms[0]; }).find("same point"), std::string::npos);
}

}  // namespace
}  // namespace fulcrum
