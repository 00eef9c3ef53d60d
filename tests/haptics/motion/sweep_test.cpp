// Sweeps of tools across walls at any speed: a wall wider than all that the hand does, so that a shell point
// beyond it has gone through.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "haptics/bake/pointshell_bake.h"
#include "haptics/math/rotation.h"
#include "tests/haptics/scenes.h"

namespace fulcrum::test {
namespace {

struct Tool {
  const char* name;
  std::shared_ptr<const Pointshell> shell;
};

struct Wall {
  const char* name;
  double thickness;  // m
  std::shared_ptr<const DistanceField> field;
};

const std::vector<Tool>& tools() {
  static const std::vector<Tool> all = [] {
    std::vector<Vec3> needle;
    for (int i = 0; i <= 40; ++i) needle.emplace_back(0, 0, -0.03 + 1.5e-3 * i);
    // A bar with a ring's outline at its end is a spanner to a wall: flat, long, off its centre of mass.
    const Solid bar = expect(build_solid(box_mesh({-0.01, -0.003, -0.05}, {0.01, 0.003, 0.09})));
    PointshellDesc spacing;
    spacing.spacing_m = 4e-3;
    return std::vector<Tool>{
        {"probe", shell_of({Vec3(0, 0, 0.02)})},
        {"needle", shell_of(needle)},
        {"spanner", std::make_shared<Pointshell>(expect(bake_pointshell(bar, spacing)))},
    };
  }();
  return all;
}

const std::vector<Wall>& walls() {
  static const std::vector<Wall> all = [] {
    std::vector<Wall> made{{"thick", 30e-3, nullptr}, {"thin", 2e-3, nullptr}};
    for (Wall& wall : made) {
      const double half = 0.5 * wall.thickness;
      wall.field = field_of(box_mesh({-half, -0.3, -0.3}, {half, 0.3, 0.3}),
                            wall.thickness > 0.01 ? 2e-3 : 0.6e-3, wall.thickness > 0.01 ? 8e-3 : 3e-3);
    }
    return made;
  }();
  return all;
}

class Hand {
public:
  explicit Hand(std::uint64_t seed) : random_(seed) {}

  // A sweep: from a free place before the wall to one behind it, at .1 to 100 m/s, spinning at up to 50
  // rad/s.
  std::vector<Pose> sweep(double tick) {
    const Vec3 from(-0.2, uniform(-0.05, 0.05), uniform(-0.05, 0.05));
    const Vec3 to(0.2, uniform(-0.05, 0.05), uniform(-0.05, 0.05));
    const double speed = std::pow(10.0, uniform(-1, 2));
    const int ticks = std::clamp(static_cast<int>((to - from).norm() / (speed * tick)), 1, 12);
    const Quat start = quaternion_exp(std::numbers::pi * direction());
    const Vec3 spin = uniform(0, 50) * direction();
    std::vector<Pose> way;
    // A slow one is shown from where it nears the wall.
    const double first = ticks == 12 ? 0.35 : 0.0;
    for (int i = 0; i <= ticks; ++i) {
      const double s = first + (1 - first) * i / ticks;
      way.push_back({quaternion_exp(spin * (tick * i)) * start, from + s * (to - from)});
    }
    return way;
  }

private:
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  Vec3 direction() {
    std::normal_distribution<double> normal;
    return Vec3(normal(random_), normal(random_), normal(random_)).normalized();
  }
  std::mt19937_64 random_;
};

void sweep(ContactResponse response, int sweeps) {
  int touched = 0;
  for (const Tool& tool : tools()) {
    for (const Wall& wall : walls()) {
      SceneDesc desc = floor_scene({Vec3::Zero()}, 0);
      desc.tool_shell = tool.shell;
      desc.scene_field = wall.field;
      desc.tool.X_WT_start = {Quat::Identity(), Vec3(-0.2, 0, 0)};
      desc.contact.response = response;
      desc.contact.stiffness = 40000;
      desc.integrator = Integrator::implicit_euler;
      World world = expect(World::build(desc));
      Hand hand(42);
      hold(world, {Quat::Identity(), Vec3(-0.2, 0, 0)}, 5);
      const int count = sweeps / static_cast<int>(tools().size() * walls().size());
      for (int i = 0; i < count; ++i) {
        for (const Pose& X_WH : hand.sweep(desc.tick_s)) {
          const TickRecord record = step(world, at(X_WH), {}).record;
          ASSERT_EQ(record.faults & kStoppingFaults, 0u) << tool.name << ' ' << wall.name << ' ' << i;
          touched += record.regions > 0 ? 1 : 0;
          double farthest = -1;
          for (const Vec3& p_T : tool.shell->positions)
            farthest = std::max(farthest, (record.X_WT * p_T).x());
          ASSERT_LT(farthest, 0) << tool.name << " got past the middle of the " << wall.name
                                 << " wall in sweep " << i;
        }
      }
    }
  }
  EXPECT_GT(touched, sweeps) << "they were to touch";
}

TEST(Sweep, NothingPassesAWall) {
  sweep(ContactResponse::constraint, 600);
  sweep(ContactResponse::quasi_static, 200);
  sweep(ContactResponse::penalty, 200);
}

TEST(Sweep, NothingPassesAWallLong) {
  sweep(ContactResponse::constraint, 600'000);
  sweep(ContactResponse::quasi_static, 200'000);
  sweep(ContactResponse::penalty, 200'000);
}

}  // namespace
}  // namespace fulcrum::test
