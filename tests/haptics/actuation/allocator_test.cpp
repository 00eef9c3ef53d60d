#include "haptics/actuation/allocator.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "haptics/math/rotation.h"
#include "tests/haptics/actuation/arms.h"
#include "tests/haptics/actuation/w6d.h"

namespace fulcrum {
namespace {

constexpr AllocationMethod kMethods[] = {AllocationMethod::exact, AllocationMethod::algorithm1,
                                         AllocationMethod::pseudoinverse};

Vec3 felt(const Allocation& allocation, const Vec3& p_HG_D) {
  return p_HG_D.cross(allocation.F_H_D.force) - allocation.F_H_D.torque;
}

// What `exact` makes small: what is missing of force, and of felt moment in units of its lever; N^2.
double missing(const Allocation& allocation, const Vec3& f_D, const Vec3& p_HG_D) {
  return (f_D - allocation.F_H_D.force).squaredNorm() +
         (p_HG_D.cross(f_D) - felt(allocation, p_HG_D)).squaredNorm() / p_HG_D.squaredNorm();
}

void expect_within_device(const DeviceDesc& device, const Wrench& F_H_D) {
  EXPECT_LE(F_H_D.force.norm(), device.max_force * (1 + 1e-9));
  EXPECT_LE(F_H_D.torque.norm(), device.max_torque * (1 + 1e-9));
}

void expect_within_limits(const Allocator& motors) {
  for (int motor = 0; motor < motors.motors(); ++motor) {
    const double limit = motors.actuators().limits()[motor];
    EXPECT_LE(std::abs(motors.taken()[motor]), limit * (1 + 1e-12) + 1e-15) << "motor " << motor;
    EXPECT_LE(std::abs(motors.load(motor, motors.taken()[motor])), 1.0);
  }
}

// A device that bounds force and torque by its motors alone.
DeviceDesc by_motors(DeviceDesc device) {
  constexpr double out_of_reach = 1e6;  // of its own limits: torque goes on counting beside force as it did
  device.max_force *= out_of_reach;
  device.max_torque *= out_of_reach;
  return device;
}

// The planar oracle, tau_1 = rho f + m and tau_2 = m with rho = 0.2 m, in six motors of which four are
// strong.
DeviceDesc planar() {
  DeviceDesc desc;
  desc.kinematics = Kinematics::arms;
  desc.renders_torque = true;
  desc.max_force = 1e3;
  desc.max_torque = 1e2;
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ(), base(-0.2, 0, 0), end(0, 0, 0);
  desc.mechanism.arms = {
      {.name = "arm",
       .joints = {arms::joint("one", z, base, 0.5, 3), arms::joint("b", y, base, 1e3, 3),
                  arms::joint("c", z, {0, 0.1, 0}, 1e3, 3), arms::joint("d", x, end, 1e3, 3),
                  arms::joint("e", y, end, 1e3, 3), arms::joint("two", z, end, 0.2, 3)},
       .end_K = end}};
  return desc;
}

TEST(Allocator, PlanarOracle) {
  const Vec3 f(0, 5, 0), r(0.085, 0, 0);
  Allocator by_algorithm(planar(), {.method = AllocationMethod::algorithm1});
  const Allocation algorithm = by_algorithm.pulse({f, Vec3::Zero()}, r, r.norm());
  EXPECT_NEAR(algorithm.force_share, 0.5, 1e-12);
  EXPECT_NEAR((algorithm.moment_share - 0.5) / 0.5, 0.941176, 5e-7);  // delta
  EXPECT_NEAR(algorithm.effort[0], 0.3, 1e-12);
  EXPECT_NEAR(algorithm.effort[5], -0.2, 1e-12);
  EXPECT_NEAR(felt(algorithm, r).z(), 0.4125, 1e-12);

  Allocator exactly(planar());
  const Allocation exact = exactly.pulse({f, Vec3::Zero()}, r, r.norm());
  EXPECT_NEAR(exact.F_H_D.force.y(), 3.2456, 5e-5);
  EXPECT_NEAR(exact.F_H_D.force.y(), 0.925 / 0.285, 1e-12);
  EXPECT_NEAR(felt(exact, r).z(), 0.425, 1e-12);
  EXPECT_NEAR(exact.effort[0], 0.5, 1e-12);
}

struct LargestForce {
  Vec3 axis;
  double newtons_at_255, newtons_at_511;
};

// At the nominal pose, without moment.
TEST(Allocator, LargestForcesOfTheW6DByThePseudoinverse) {
  for (const auto& [axis, at_255, at_511] :
       {LargestForce{Vec3::UnitX(), 2.600, 5.211}, LargestForce{Vec3::UnitY(), 1.394, 2.794},
        LargestForce{Vec3::UnitZ(), 1.295, 2.595}}) {
    Allocator study(by_motors(w6d::device(0.255, 0.145)), {.method = AllocationMethod::pseudoinverse});
    Allocator whole(by_motors(w6d::device(0.511, 0.145)), {.method = AllocationMethod::pseudoinverse});
    EXPECT_NEAR(study.allocate_uniform({100 * axis, Vec3::Zero()}).F_H_D.force.norm(), at_255, 5.1e-4);
    EXPECT_NEAR(whole.allocate_uniform({100 * axis, Vec3::Zero()}).F_H_D.force.norm(), at_511, 5.1e-4);
  }
}

TEST(Allocator, LargestForcesOfTheW6DWithItsSpareMotor) {
  for (const auto& [axis, at_255, at_511] :
       {LargestForce{Vec3::UnitX(), 3.325, 6.663}, LargestForce{Vec3::UnitY(), 1.980, 3.969},
        LargestForce{Vec3::UnitZ(), 1.981, 3.969}}) {
    Allocator study(by_motors(w6d::device(0.255, 0.145))), whole(by_motors(w6d::device(0.511, 0.145)));
    const Allocation allocation = study.allocate_uniform({100 * axis, Vec3::Zero()});
    EXPECT_NEAR(allocation.F_H_D.force.norm(), at_255, 5.1e-4);
    EXPECT_NEAR(allocation.F_H_D.torque.norm(), 0, 1e-12);
    EXPECT_NEAR(whole.allocate_uniform({100 * axis, Vec3::Zero()}).F_H_D.force.norm(), at_511, 5.1e-4);
  }
}

// The motor that saturates by the force is loaded further by the moment.
TEST(Allocator, Algorithm1FindsNoMomentOnTheW6DsAxes) {
  const Vec3 r = 0.12 * Vec3(0.4, 0.7, 0.6).normalized();
  for (const Vec3& axis : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY()), Vec3(Vec3::UnitZ())}) {
    Allocator motors(w6d::device(0.255, 0.145), {.method = AllocationMethod::algorithm1});
    const Allocation allocation = motors.pulse({10 * axis, Vec3::Zero()}, r, r.norm());
    motors.reserve(allocation);
    EXPECT_LT(allocation.force_share, 1);
    EXPECT_GE(allocation.moment_share, allocation.force_share);
    expect_within_limits(motors);
  }
}

struct Case {
  Pose X_DH;
  Vec3 f_D, p_HG_D;
};

Case random_case(SplitMix& random) {
  const Pose X_DH{quaternion_exp(0.4 * arms::random_vector(random)), 0.05 * arms::random_vector(random)};
  const double size = std::exp(8 * random.uniform() - 3);  // 0.05 to 150 N
  return {X_DH, size * arms::random_vector(random).normalized(),
          0.2 * random.uniform() * arms::random_vector(random).normalized()};
}

TEST(Allocator, ExactIsNeverWorseThanTheOthersAndKeepsItsWord) {
  for (const DeviceDesc& device : {w6d::device(0.255, 0.145), arms::serial6(), by_motors(arms::serial6())}) {
    SplitMix random(1);
    int better = 0;
    for (int i = 0; i < 10000; ++i) {
      const auto [X_DH, f_D, p_HG_D] = random_case(random);
      double by_exact = 0;
      for (const AllocationMethod method : kMethods) {
        Allocator motors(device, {.method = method});
        motors.begin(X_DH);
        const Allocation allocation = motors.pulse({f_D, Vec3::Zero()}, p_HG_D, p_HG_D.norm());
        motors.reserve(allocation);
        expect_within_limits(motors);
        expect_within_device(device, allocation.F_H_D);
        const double size = f_D.norm();
        EXPECT_NEAR(allocation.F_H_D.force.cross(f_D).norm(), 0, 1e-8 * size * size);
        const Vec3 whole = p_HG_D.cross(f_D), of_it = felt(allocation, p_HG_D);
        EXPECT_NEAR((of_it - allocation.moment_share * whole).norm(), 0, 1e-8 * size);
        EXPECT_LE(allocation.moment_share, 1 + 1e-12);
        const double here = missing(allocation, f_D, p_HG_D);
        if (method == AllocationMethod::exact)
          by_exact = here;
        else
          EXPECT_LE(by_exact, here + 1e-9 * size * size) << i;
        if (method == AllocationMethod::algorithm1 && by_exact < 0.999 * here) ++better;
      }
    }
    EXPECT_GT(better, 100);
  }
}

// Against a search over shares: whether a pair of them can be had is asked of the motors' limits, with the
// one spare direction as an interval, and of the device's. Strong motors leave it to the device, and torque
// that comes first makes its bound an ellipse off the middle.
TEST(Allocator, NoPairOfSharesOnAGridIsBetterThanExact) {
  SplitMix random(2);
  int beyond_device = 0;
  for (int i = 0; i < 120; ++i) {
    const DeviceDesc device = i % 3 == 0 ? w6d::device(0.255, 0.145) : w6d::device(2, 1);
    const Case drawn = random_case(random);
    const Vec3 &f_D = drawn.f_D, &p_HG_D = drawn.p_HG_D;
    const Wrench first =
        i % 3 == 2 ? Wrench{arms::random_vector(random), 0.15 * arms::random_vector(random)} : Wrench{};
    Allocator motors(device);
    motors.begin(drawn.X_DH);
    const Allocation taken = motors.wrench(first);
    motors.reserve(taken);
    const Allocation exact = motors.pulse({f_D, Vec3::Zero()}, p_HG_D, p_HG_D.norm());
    const auto device_can = [&](double gamma, double mu) {
      const Vec3 torque = taken.F_H_D.torque + (gamma - mu) * p_HG_D.cross(f_D);
      return (taken.F_H_D.force + gamma * f_D).norm() <= device.max_force &&
             torque.norm() <= device.max_torque;
    };
    if (!device_can(1, 1)) ++beyond_device;
    MotorSpace space(motors.actuators());
    space.factorise(motors.actuators().wrenches(), 0.05);
    const Effort none = space.spare().col(0), limits = motors.actuators().limits();
    ASSERT_GT(none.norm(), 0.99);
    EXPECT_NEAR(space.wrench(none).force.norm() + space.wrench(none).torque.norm(), 0, 1e-12);
    const Vec3 whole = p_HG_D.cross(f_D);
    constexpr int steps = 150;
    double best = 1e300;
    for (int g = 0; g <= steps; ++g) {
      for (int u = 0; u <= steps; ++u) {
        const double gamma = 1.0 * g / steps, mu = 1.0 * u / steps;
        if (!device_can(gamma, mu)) continue;
        const Effort effort = taken.effort + space.smallest({gamma * f_D, (gamma - mu) * whole});
        double low = -1e300, high = 1e300;
        for (int m = 0; m < motors.motors(); ++m) {
          const double a = (-limits[m] - effort[m]) / none[m], b = (limits[m] - effort[m]) / none[m];
          if (std::abs(none[m]) > 1e-12) {
            low = std::max(low, std::min(a, b));
            high = std::min(high, std::max(a, b));
          } else if (std::abs(effort[m]) > limits[m]) {
            high = -1e300;
          }
        }
        if (low > high) continue;
        const double miss = (1 - gamma) * (1 - gamma) * f_D.squaredNorm() +
                            (1 - mu) * (1 - mu) * whole.squaredNorm() / p_HG_D.squaredNorm();
        best = std::min(best, miss);
      }
    }
    const double by_exact = missing(exact, f_D, p_HG_D);
    EXPECT_LE(by_exact, best + 1e-9 * f_D.squaredNorm()) << i;
    EXPECT_GE(by_exact, best - 0.05 * f_D.squaredNorm()) << i;  // the grid's width
    expect_within_device(device, taken.F_H_D + exact.F_H_D);
  }
  EXPECT_GT(beyond_device, 40);
}

// Whatever they are about and however many there are, all wrenches of a tick together are within what the
// device may give, at stretched arms and with a dead motor too.
TEST(Allocator, TheDevicesForceAndTorqueHold) {
  SplitMix random(17);
  DeviceDesc lame = arms::serial6();
  lame.mechanism.arms[0].joints[4].max_torque = 0;
  for (const DeviceDesc& device :
       {w6d::device(0.511, 0.145), w6d::device(20, 5), arms::serial6(), arms::freedom6s(), lame}) {
    for (const AllocationMethod method : kMethods) {
      Allocator motors(device, {.method = method});
      for (int i = 0; i < 2000; ++i) {
        motors.begin({quaternion_exp(random.uniform() * arms::random_vector(random)),
                      0.3 * random.uniform() * arms::random_vector(random)});
        Wrench sum;
        const auto take = [&](const Allocation& allocation) {
          motors.reserve(allocation);
          sum += allocation.F_H_D;
          ASSERT_TRUE(sum.is_finite());
          expect_within_device(device, sum);
          expect_within_limits(motors);
        };
        const Vec3 p_HG_D = 0.2 * arms::random_vector(random);
        take(motors.wrench({10 * arms::random_vector(random), arms::random_vector(random)}, p_HG_D));
        take(motors.pulse({50 * arms::random_vector(random), Vec3::Zero()}, p_HG_D, p_HG_D.norm()));
        take(motors.allocate_uniform({arms::random_vector(random), 0.1 * arms::random_vector(random)}));
      }
    }
  }
}

TEST(Allocator, WhatTheMotorsCanDoIsDoneToTheBit) {
  for (const DeviceDesc& device : {w6d::device(0.511, 0.145), arms::serial6(), DeviceDesc{}}) {
    for (const AllocationMethod method : kMethods) {
      Allocator motors(device, {.method = method});
      Wrench wanted{Vec3(0.3, -0.2, 0.1), Vec3(0.004, 0.002, -0.003)};
      if (!device.renders_torque) wanted.torque.setZero();
      const Allocation allocation = motors.wrench(wanted);
      EXPECT_FALSE(allocation.clamped());
      EXPECT_EQ(allocation.F_H_D.force, wanted.force);
      EXPECT_EQ(allocation.F_H_D.torque, wanted.torque);
      const Vec3 force = motors.actuators().wrenches().topRows<3>() * allocation.effort;
      EXPECT_NEAR((force - wanted.force).norm(), 0, 1e-12);
    }
  }
}

TEST(Allocator, SaturationKeepsTheDirections) {
  for (const DeviceDesc& device :
       {by_motors(w6d::device(0.511, 0.145)), by_motors(arms::serial6()), by_motors(arms::phantom())}) {
    for (const AllocationMethod method : kMethods) {
      Allocator motors(device, {.method = method});
      Wrench wanted{Vec3(30, -20, 10), Vec3(1, 2, -1)};
      if (!device.renders_torque) wanted.torque.setZero();
      const Allocation allocation = motors.wrench(wanted);
      EXPECT_TRUE(allocation.clamped());
      motors.reserve(allocation);
      expect_within_limits(motors);
      double largest = 0;
      for (int m = 0; m < motors.motors(); ++m)
        largest = std::max(largest, std::abs(motors.load(m, motors.taken()[m])));
      EXPECT_NEAR(largest, 1, 1e-9);
      EXPECT_NEAR(allocation.F_H_D.force.normalized().dot(wanted.force.normalized()), 1, 1e-9);
      if (device.renders_torque && allocation.F_H_D.torque.norm() > 1e-9)
        EXPECT_NEAR(allocation.F_H_D.torque.normalized().dot(wanted.torque.normalized()), 1, 1e-9);
    }
  }
}

// What came first keeps its motors; the rest gets what they have left.
TEST(Allocator, WrenchesOfOneTickShareTheMotors) {
  Allocator motors(w6d::device(0.255, 0.145));
  SplitMix random(9);
  for (int i = 0; i < 1000; ++i) {
    const auto [X_DH, f_D, p_HG_D] = random_case(random);
    motors.begin(X_DH);
    const Allocation continuous = motors.wrench({0.02 * f_D, Vec3::Zero()});
    motors.reserve(continuous);
    const Allocation pulse = motors.pulse({f_D, Vec3::Zero()}, p_HG_D, p_HG_D.norm());
    motors.reserve(pulse);
    const Allocation tone = motors.allocate_uniform({Vec3(0.1, 0.2, 0), Vec3(0.01, 0, 0)});
    motors.reserve(tone);
    expect_within_limits(motors);
    EXPECT_NEAR((continuous.effort + pulse.effort + tone.effort - motors.taken()).norm(), 0, 1e-15);
    const Vec3 t = tone.F_H_D.force;
    EXPECT_NEAR((t - tone.force_share * Vec3(0.1, 0.2, 0)).norm(), 0, 1e-9);
    EXPECT_NEAR((tone.F_H_D.torque - tone.force_share * Vec3(0.01, 0, 0)).norm(), 0, 1e-9);
  }
}

TEST(Allocator, AMotorWithoutALimitsWorthTakesNoPart) {
  for (int dead = 0; dead < 7; ++dead) {
    DeviceDesc device = w6d::device(0.255, 0.145);
    if (dead == 6)
      device.mechanism.spin->max_torque = 0;
    else
      device.mechanism.arms[static_cast<std::size_t>(dead / 3)]
          .joints[static_cast<std::size_t>(dead % 3)]
          .max_torque = 0;
    Allocator motors(device);
    SplitMix random(4);
    for (int i = 0; i < 300; ++i) {
      const auto [X_DH, f_D, p_HG_D] = random_case(random);
      motors.begin(X_DH);
      const Allocation allocation = motors.pulse({f_D, Vec3::Zero()}, p_HG_D, p_HG_D.norm());
      motors.reserve(allocation);
      EXPECT_EQ(motors.taken()[dead], 0.0);
      EXPECT_EQ(motors.load(dead, motors.taken()[dead]), 0.0);
      expect_within_limits(motors);
      EXPECT_TRUE(allocation.F_H_D.is_finite());
      EXPECT_NEAR(allocation.F_H_D.force.cross(f_D).norm(), 0, 1e-5 * f_D.squaredNorm());
    }
  }
}

TEST(Allocator, SingularAndFarPosesGiveFiniteEffortsWithinLimits) {
  SplitMix random(6);
  for (const DeviceDesc& device : {w6d::device(0.255, 0.145), arms::serial6(), arms::phantom()}) {
    for (const AllocationMethod method : kMethods) {
      Allocator motors(device, {.method = method});
      for (int i = 0; i < 300; ++i) {
        motors.begin({quaternion_exp(3 * arms::random_vector(random)), 0.4 * arms::random_vector(random)});
        const Allocation allocation = motors.pulse({20 * arms::random_vector(random), Vec3::Zero()},
                                                   0.1 * arms::random_vector(random), 0.1);
        motors.reserve(allocation);
        EXPECT_TRUE(allocation.F_H_D.is_finite());
        EXPECT_TRUE(allocation.effort.allFinite());
        expect_within_limits(motors);
      }
    }
  }
}

// Where motors set force alone, the moment that the hand feels is that of the force.
TEST(Allocator, WithoutTorqueMotorsTheFeltMomentIsTheForces) {
  const Vec3 f(30, -20, 10), r(0, 0.1, 0.05);
  for (const AllocationMethod method : kMethods) {
    Allocator motors(arms::phantom(), {.method = method});
    const Allocation allocation = motors.pulse({f, Vec3::Zero()}, r, r.norm());
    EXPECT_LT(allocation.force_share, 1);
    EXPECT_EQ(allocation.moment_share, allocation.force_share);
    EXPECT_TRUE(allocation.F_H_D.torque.isZero(0));
    EXPECT_NEAR((felt(allocation, r) - allocation.moment_share * r.cross(f)).norm(), 0, 1e-9);
  }
}

TEST(Allocator, NothingWantedIsNothing) {
  Allocator motors(w6d::device(0.255, 0.145));
  EXPECT_TRUE(motors.pulse({}, Vec3(0, 0.1, 0), 0.1).F_H_D.is_zero());
  EXPECT_TRUE(motors.wrench({}).F_H_D.is_zero());
  EXPECT_TRUE(motors.allocate_uniform({}).F_H_D.is_zero());
  EXPECT_TRUE(motors.taken().isZero(0));
}

TEST(Allocator, AMouseHasNoMotors) {
  DeviceDesc desc;
  desc.renders_force = false;
  Allocator motors(desc);
  EXPECT_EQ(motors.motors(), 0);
  EXPECT_TRUE(motors.wrench({Vec3(1, 0, 0), Vec3::Zero()}).F_H_D.is_zero());
  EXPECT_TRUE(motors.pulse({Vec3(1, 0, 0), Vec3::Zero()}, Vec3::UnitX(), 1).F_H_D.is_zero());
}

}  // namespace
}  // namespace fulcrum
