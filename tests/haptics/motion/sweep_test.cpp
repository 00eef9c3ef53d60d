// Probe and needle across a thick and a thin wall. The spanner's sweeps are in
// tests/scenarios/piping/sweep_test.cpp; both together are a million when all tests run, and a thousand
// always: 600, 200 and 200 of each thousand under the responses constraint, quasi_static and penalty.

#include "tests/haptics/motion/sweep.h"

namespace fulcrum::test {
namespace {

SceneDesc scene_of(const std::vector<Vec3>& points) {
  SceneDesc desc = floor_scene(points, 0);
  desc.contact.stiffness = 40000;
  desc.integrator = Integrator::implicit_euler;
  return desc;
}

// Each tool across each wall, so often.
void sweep(ContactResponse response, int sweeps) {
  std::vector<Vec3> needle;
  for (int i = 0; i <= 40; ++i) needle.emplace_back(0, 0, -0.03 + 1.5e-3 * i);
  sweep_walls("probe", scene_of({Vec3(0, 0, 0.02)}), response, sweeps);
  sweep_walls("needle", scene_of(needle), response, sweeps);
}

TEST(Sweep, NothingPassesAWall) {
  sweep(ContactResponse::constraint, 132);
  sweep(ContactResponse::quasi_static, 32);
  sweep(ContactResponse::penalty, 32);
}

TEST(Sweep, NothingPassesAWallLong) {
  sweep(ContactResponse::constraint, 138'500);
  sweep(ContactResponse::quasi_static, 38'500);
  sweep(ContactResponse::penalty, 38'500);
}

}  // namespace
}  // namespace fulcrum::test
