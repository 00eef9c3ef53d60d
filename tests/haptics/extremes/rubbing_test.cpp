// Friction far from any that a scenario names, on soft and on stiff contact, in a whole loop: a hand that
// presses a stand of three feet onto the floor, 1 cm to the side and askew. 1e7 N/m and 10 are the most that
// a scenario may name.

#include <gtest/gtest.h>

#include "haptics/math/rotation.h"
#include "tests/haptics/extremes/closed_loop.h"

namespace fulcrum::test {
namespace {

TEST_P(EveryResponseThatRests, AnyFrictionComesToRest) {
  for (const double friction : {1e-4, 0.1, 0.3, 3.0, 10.0}) {
    for (const double k : {1e2, 2e4, 1e7}) {
      for (const Integrator integrator : {Integrator::semi_implicit_euler, Integrator::implicit_euler}) {
        SceneDesc scene = answering(pressing_scene());
        scene.integrator = integrator;
        scene.contact.stiffness = k;
        scene.contact.friction = friction;
        scene.contact.torsional_friction = scene.contact.rolling_friction = 1e-3 * friction;
        HandTask hand = pressing_hand();
        hand.path = HandPath({Waypoint{{Quat::Identity(), Vec3(0, 0.013, 0)}, 0, 0.6},
                              Waypoint{{quaternion_exp(Vec3(0, 0.3, 0.02)), Vec3(0.01, 0.005, 0)}, 0.3, 0}});
        const Verdict verdict = run_closed_loop(scene, hand, 4);
        EXPECT_TRUE(verdict.at_rest())
            << friction << ", " << k << ": " << verdict.late_tool << " m, " << verdict.late_force << " N";
        EXPECT_FALSE(verdict.faults & kStoppingFaults) << friction << ", " << k;
        EXPECT_LE(verdict.force_max, scene.device.max_force * (1 + 1e-12));
        const Vec3 F = verdict.last.contact_F_T_W.force;
        // Above, on the stiffest contact, a tool without mass may not find its balance in the steps of a
        // tick.
        if (friction <= 3)
          EXPECT_LT((F + verdict.last.coupling_F_T_W.force).norm(), 0.05) << friction << ", " << k;
        EXPECT_LE(std::hypot(F.x(), F.z()), friction * F.y() * 1.01 + 5e-3) << friction << ", " << k;
      }
    }
  }
}

}  // namespace
}  // namespace fulcrum::test
