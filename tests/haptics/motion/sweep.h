#pragma once
// Random sweeps of tools across what has to stop them, at .1 to 100 m/s: what probe, needle and spanner
// share.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "haptics/math/rotation.h"
#include "tests/haptics/scenes.h"

namespace fulcrum::test {

// A hand's way from a free place straight on to one behind what is in between.
struct Sweep {
  Pose X_WT;                   // at its start
  Vec3 along = Vec3::UnitX();  // (3) unit
  double length = 0;           // m
  double speed = 0;            // m/s
  Vec3 spin = Vec3::Zero();    // (3) rad/s

  Pose at(double s, double t) const { return {quaternion_exp(spin * t) * X_WT.q, X_WT.p + s * along}; }
  // Tick by tick. A slow one is shown at its own speed from `first` m on, as far as it then comes.
  std::vector<Pose> ticks(double tick_s, double first) const {
    constexpr int most = 24;
    const double step = speed * tick_s;
    double s = length > most * step ? std::clamp(first, 0.0, length) : 0.0;
    std::vector<Pose> way{at(s, 0)};
    for (int i = 1; i <= most && s < length; ++i) {
      s = std::min(s + step, length);
      way.push_back(at(s, i * tick_s));
    }
    return way;
  }
};

class SweepingHand {
public:
  static constexpr std::uint64_t kSeed = 42;

  Sweep sweep(const Vec3& from, const Vec3& to) {
    Sweep sweep;
    sweep.speed = std::pow(10.0, uniform(-1, 2));
    sweep.X_WT = {quaternion_exp(std::numbers::pi * direction()), from};
    sweep.length = (to - from).norm();
    sweep.along = (to - from) / sweep.length;
    sweep.spin = uniform(0, 50) * direction();
    return sweep;
  }
  // Each coordinate for itself, in the order x, y, z.
  Vec3 place(const Vec3& low, const Vec3& high) {
    Vec3 p;
    for (Eigen::Index i = 0; i < 3; ++i) p[i] = uniform(low[i], high[i]);
    return p;
  }

private:
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  Vec3 direction() {
    std::normal_distribution<double> normal;
    Vec3 d;
    for (double& x : d) x = normal(random_);
    return d.normalized();
  }
  std::mt19937_64 random_{kSeed};
};

// A tick in which the hand wants the tool at X_WG.
inline TickRecord lead(World& world, const Pose& X_WG) {
  const SceneDesc& desc = world.desc();
  return step(world, at(desc.mapping.handle_in_device(X_WG * desc.tool.X_HT.inverse())), {}).record;
}

// Of .6 m by .6 m: wider than all that the tool does, so that a shell point beyond it has gone through.
struct SweptWall {
  const char* name;
  double half;  // m, of its thickness
  std::shared_ptr<const DistanceField> field;
};

inline constexpr double kSweptWallHalfWidth = 0.3;  // m

inline const std::vector<SweptWall>& swept_walls() {
  const auto field = [](double half, double voxel, double band) {
    const Vec3 high(half, kSweptWallHalfWidth, kSweptWallHalfWidth);
    return field_of(box_mesh(-high, high), voxel, band);
  };
  static const std::vector<SweptWall> all{{"thick", 15e-3, field(15e-3, 2e-3, 8e-3)},
                                          {"thin", 1e-3, field(1e-3, 0.6e-3, 3e-3)}};
  return all;
}

// m, of the shell along the wall's normal, so turned.
inline double reach_to_wall(const Pointshell& shell_T, const Quat& q_WT) {
  const Vec3 normal_T = q_WT.conjugate() * Vec3::UnitX();
  double reach = -std::numeric_limits<double>::infinity();
  for (const Vec3& p_T : shell_T.positions) reach = std::max(reach, normal_T.dot(p_T));
  return reach;
}

// Sweeps the scene's tool across each wall so often: no shell point gets to its middle.
inline void sweep_walls(const std::string& tool, SceneDesc desc, ContactResponse response, int sweeps) {
  for (const SweptWall& wall : swept_walls()) {
    SCOPED_TRACE(tool + ", " + wall.name + " wall, " + std::string(name_of(response)));
    desc.scene_field = wall.field;
    desc.tool.X_WT_start = {Quat::Identity(), Vec3(-0.2, 0, 0)};
    desc.tool.weight = false;  // which would draw it down the wall, sweep by sweep, and round its edge
    desc.contact.response = response;
    World world = expect(World::build(desc));
    const Pointshell& shell_T = *desc.tool_shell;
    for (int i = 0; i < 5; ++i) lead(world, desc.tool.X_WT_start);
    SweepingHand hand;
    int touched = 0;
    for (int i = 0; i < sweeps; ++i) {
      const Vec3 from = hand.place({-0.2, -0.05, -0.05}, {-0.2, 0.05, 0.05});
      const Vec3 to = hand.place({0.2, -0.05, -0.05}, {0.2, 0.05, 0.05});
      const Sweep sweep = hand.sweep(from, to);
      // A quarter of a millimetre before it touches: .1 m/s then crosses the thin wall.
      const double touch = -wall.half - reach_to_wall(shell_T, sweep.X_WT.q);
      for (const Pose& X_WG : sweep.ticks(desc.tick_s, (touch - 0.25e-3 - from.x()) / sweep.along.x())) {
        const TickRecord record = lead(world, X_WG);
        touched += record.regions > 0 ? 1 : 0;
        ASSERT_EQ(record.faults & kStoppingFaults, 0u)
            << record.depth_max << " m deep in sweep " << i << " of seed " << hand.kSeed;
        const double aside = record.X_WT.p.tail<2>().cwiseAbs().maxCoeff() + shell_T.max_radius_m;
        ASSERT_LT(aside, kSweptWallHalfWidth)
            << "round the edge, in sweep " << i << " of seed " << hand.kSeed;
        const double farthest = record.X_WT.p.x() + reach_to_wall(shell_T, record.X_WT.q);
        ASSERT_LT(farthest, 0) << "past the middle, in sweep " << i << " of seed " << hand.kSeed;
      }
    }
    EXPECT_GT(touched, sweeps) << "it was to touch";
  }
}

}  // namespace fulcrum::test
