// Truths: m = .1 kg, b = .5 N s/m, T = 1 ms, a wall on both sides, exact hold. Limits from the growth rates
// of the linear loop; passivity in closed form; a Phantom-like device as in N. Diolaiti et al., IEEE Trans.
// Robotics 22(2), 2006.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/analysis/simulated_wall.h"
#include "engine/analysis/stability/passivity.h"
#include "haptics/device/linear_loop.h"

namespace fulcrum::analysis::stability {
namespace {

constexpr double kStart = 0.1;  // m/s

WallLoop reference(int delay_ticks = 0, double tick_s = 1e-3) {
  return {.axis = {.mass = 0.1, .damping = 0.5}, .tick_s = tick_s, .delay_ticks = delay_ticks};
}

WallLoop phantom_like() {
  return {.axis = {.mass = 0.072, .damping = 0.005, .friction = 0.038, .encoder_step = 28e-6}};
}

TEST(ExactBorder, IsWhereTheLinearLoopLosesStability) {
  EXPECT_NEAR(exact_stiffness_limit(reference(), 0), 1000.834, 5e-4);
  EXPECT_NEAR(exact_stiffness_limit(reference(), 0.25), 1497.51, 5e-3);
  EXPECT_NEAR(exact_stiffness_limit(reference(), 2), 4905.3, 0.05);
  EXPECT_NEAR(exact_stiffness_limit(reference(1), 0), 333.80, 5e-3);
  EXPECT_NEAR(exact_stiffness_limit(reference(0, 60e-3), 0), 17.5, 0.05);
}

TEST(ExactBorder, WithoutDampingOnlyTheWallsOwnIsThere) {
  WallLoop loop = reference();
  loop.axis.damping = 0;
  EXPECT_EQ(exact_stiffness_limit(loop, 0), 0);  // a held spring alone always makes energy
  EXPECT_GT(exact_stiffness_limit(loop, 1), 100);
}

TEST(ExactBorder, BeyondTheLimitOfDampingNothingIsStable) {
  for (int delay : {0, 1, 2}) {
    const double B = exact_damping_limit(reference(delay));
    EXPECT_GT(exact_stiffness_limit(reference(delay), 0.98 * B), 0) << delay;
    EXPECT_EQ(exact_stiffness_limit(reference(delay), 1.02 * B), 0) << delay;
  }
}

TEST(PassiveBorder, IsColgatesAndSchenkels) {
  for (double B : {0.0, 0.1, 0.25, 0.4})
    EXPECT_NEAR(passive_stiffness_limit(reference(), B), 2 * (0.5 - B) / 1e-3, 1e-6) << B;
  EXPECT_EQ(passive_stiffness_limit(reference(), 0.51), 0);
  for (int n : {1, 2, 5})
    EXPECT_NEAR(passive_stiffness_limit(reference(n), 0), 0.5 / ((n + 0.5) * 1e-3), 1e-6) << n;
}

TEST(PassiveBorder, LiesBelowTheExactOne) {
  for (int n : {0, 1, 2, 4})
    for (double B : {0.0, 0.05, 0.2, 0.45})
      EXPECT_LE(passive_stiffness_limit(reference(n), B), exact_stiffness_limit(reference(n), B)) << n << B;
}

TEST(Plane, NamedPointsLieWhereTheyShould) {
  struct Case {
    Wall wall;
    bool stable, passive;
  };
  for (const Case& c :
       {Case{{900, 0}, true, true}, Case{{600, 0.25}, true, false}, Case{{4000, 2}, true, false},
        Case{{1100, 0}, false, false}, Case{{5500, 2}, false, false}}) {
    EXPECT_EQ(exact_growth(reference(), c.wall) < 0, c.stable) << c.wall.K;
    EXPECT_EQ(settles(reference(), c.wall, kStart), c.stable) << c.wall.K;
    EXPECT_EQ(c.wall.K < passive_stiffness_limit(reference(), c.wall.B), c.passive) << c.wall.K;
  }
}

TEST(SimulatedBorder, IsTheExactOneOfALinearDevice) {
  for (int delay : {0, 1, 2}) {
    const WallLoop loop = reference(delay);
    const double most = exact_damping_limit(loop);
    for (double B : {0.0, 0.25, 2.0, 0.5 * most, 0.9 * most}) {
      const double exact = exact_stiffness_limit(loop, B);
      EXPECT_NEAR(simulated_stiffness_limit(loop, B, kStart), exact, 0.05 * exact) << delay << " " << B;
    }
    EXPECT_EQ(simulated_stiffness_limit(loop, 1.1 * most, kStart), 0) << delay;
  }
}

TEST(SimulatedBorder, WithALowPassIsTheExactOneToo) {
  for (double pole : {0.5, 0.686, 0.9}) {
    WallLoop loop = reference();
    loop.filter_pole = pole;
    for (double B : {1.0, 0.5 * exact_damping_limit(loop)}) {
      const double exact = exact_stiffness_limit(loop, B);
      EXPECT_NEAR(simulated_stiffness_limit(loop, B, kStart), exact, 0.05 * exact) << pole << " " << B;
    }
    EXPECT_LT(exact_stiffness_limit(loop, 10), exact_stiffness_limit(reference(), 10)) << "late damping";
  }
}

TEST(SimulatedGrowth, IsTheExactOneOfALinearDevice) {
  for (const Wall& wall : {Wall{900, 0}, Wall{1100, 0}, Wall{2000, 0}, Wall{4000, 2}, Wall{5500, 2}}) {
    const double exact = exact_growth(reference(), wall);
    EXPECT_NEAR(swing(reference(), wall, kStart).growth, exact, 0.02 * std::abs(exact)) << wall.K;
  }
}

// Friction holds what is slow; what is fast grows.
TEST(SimulatedBorder, OfAPhantomDependsOnTheSpeed) {
  EXPECT_TRUE(settles(phantom_like(), {500, 0}, 0.1));
  EXPECT_FALSE(settles(phantom_like(), {500, 0}, 0.3));
  EXPECT_TRUE(settles(phantom_like(), {1000, 0}, 0.05));
  EXPECT_FALSE(settles(phantom_like(), {1000, 0}, 0.2));
  EXPECT_TRUE(settles(phantom_like(), {2000, 0}, 0.02));
  EXPECT_FALSE(settles(phantom_like(), {2000, 0}, 0.1));
}

WallLoop diolaiti_loop(double beta, double sigma, double K) {
  WallLoop loop{.axis = {.mass = 0.1, .encoder_step = 28e-6}};
  loop.axis.damping = beta * K * loop.tick_s;
  loop.axis.friction = sigma * K * loop.axis.encoder_step;
  return loop;
}

TEST(Diolaiti, ClearCasesDoAsTheRegionSays) {
  constexpr double K = 1000;
  struct Case {
    double beta, sigma;
    DiolaitiRegion region;
    bool slow_settles, fast_settles;
  };
  for (const Case& c : {Case{3, 3, DiolaitiRegion::settles, true, true},
                        Case{0.05, 3, DiolaitiRegion::settles_if_slow, true, false},
                        Case{0.05, 0.05, DiolaitiRegion::grows, false, false}}) {
    const WallLoop loop = diolaiti_loop(c.beta, c.sigma, K);
    const DiolaitiPlace place = diolaiti_place(loop, K);
    EXPECT_NEAR(place.beta, c.beta, 1e-12);
    EXPECT_NEAR(place.sigma, c.sigma, 1e-12);
    EXPECT_EQ(diolaiti_region(place), c.region);
    const double w = std::sqrt(K / loop.axis.mass), step = loop.axis.encoder_step;
    EXPECT_EQ(settles(loop, {K, 0}, 3 * step * w), c.slow_settles) << c.beta << " " << c.sigma;
    EXPECT_EQ(settles(loop, {K, 0}, 3000 * step * w), c.fast_settles) << c.beta << " " << c.sigma;
  }
}

TEST(Diolaiti, DampingWithoutFrictionLeavesABoundedTrembling) {
  const WallLoop loop = diolaiti_loop(1, 0.05, 1000);
  EXPECT_EQ(diolaiti_region(diolaiti_place(loop, 1000)), DiolaitiRegion::limit_cycle);
  const Swing end = swing(loop, {1000, 0}, 0.1);
  EXPECT_GT(end.late, 0.1 * loop.axis.encoder_step);
  EXPECT_LT(end.late, loop.axis.encoder_step);
  EXPECT_EQ(swing(diolaiti_loop(1, 1, 1000), {1000, 0}, 0.1).late, 0) << "friction holds the same";
}

TEST(PortEnergy, IsTheObserversAndTheTruths) {
  const std::vector<double> energy = port_energy(reference(), {2000, 0}, 0.1, 1001);
  EXPECT_NEAR(energy[1000], -0.1388, 5e-5);
}

// What the wall took, what the device's damper ate and what still moves is what the swing began with.
TEST(PortEnergy, BalancesWithTheMechanics) {
  const WallLoop loop = reference();
  for (const Wall& wall : {Wall{900, 0}, Wall{600, 0.25}, Wall{4000, 2}}) {
    const std::vector<double> energy = port_energy(loop, wall, kStart, 1001);
    SimulatedWall run(loop, wall, kStart);
    double eaten = 0, v = kStart;
    for (int i = 0; i < 1000; ++i) {
      run.tick();
      eaten += loop.axis.damping * (v * v + v * run.v() + run.v() * run.v()) / 3 * loop.tick_s;
      v = run.v();
    }
    const double began = 0.5 * loop.axis.mass * kStart * kStart;
    EXPECT_NEAR(energy[1000] + eaten + 0.5 * loop.axis.mass * v * v, began, 0.01 * began) << wall.K;
  }
}

// A cycle of a loop that neither grows nor decays: what the held spring makes is what the damper eats.
TEST(PortEnergy, OfACycleIsTheClosedForm) {
  const double K = exact_stiffness_limit(reference(), 0), w = std::sqrt(K / 0.1);
  const int cycle = static_cast<int>(std::lround(2 * std::numbers::pi / w / 1e-3)), cycles = 20;
  const std::vector<double> energy = port_energy(reference(), {K, 0}, 0.1, 1 + cycles * cycle);
  const double made = -(energy.back() - energy.front()) / cycles;
  EXPECT_NEAR(made, energy_per_cycle(K, 0.1 / w, w, 1e-3), 0.02 * made);
}

}  // namespace
}  // namespace fulcrum::analysis::stability
