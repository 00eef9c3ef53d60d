// The spanner across the walls that probe and needle are swept across (the rest of the million is in
// tests/haptics/motion/sweep_test.cpp), and across piping's own pipes, judged on the triangles. The judge
// sets the number: a sweep at the pipes takes 10 to 30 ms of the processor, most of it the judge's, and one
// at a wall 1 to 2. Always: 6 s; long: 8 minutes.

#include "tests/haptics/motion/sweep.h"

#include "tests/scenarios/piping/path_audit.h"
#include "tests/scenarios/piping/piping.h"

namespace fulcrum::test {
namespace {

SceneDesc spanner_scene() {
  SceneDesc desc = piping().haptic.scene;
  // A sweep begins with a jump of the hand, which a filter would drag on over half of it.
  desc.velocity.kind = VelocityEstimatorKind::difference;
  return desc;
}

// Without the plant's edges, which springs do not know and walls do not have.
SceneDesc without_edges(SceneDesc desc) {
  desc.scene_edges = nullptr;
  desc.tool_field = nullptr;
  return desc;
}

// From where the tool is straight on towards a place in the plant and through it.
void sweep_pipes(ContactResponse response, int sweeps) {
  SCOPED_TRACE(name_of(response));
  SceneDesc desc = spanner_scene();
  if (response != ContactResponse::constraint) desc = without_edges(desc);
  desc.contact.response = response;
  World world = expect(World::build(desc));
  PathAudit audit(piping().haptic.scene_W, *desc.tool_shell);
  const Box3 plant = piping().haptic.scene_W.bounds();
  SweepingHand hand;
  TickRecord record = lead(world, desc.tool.X_WT_start);
  int touched = 0;
  for (int i = 0; i < sweeps; ++i) {
    const Vec3 from = record.X_WT.p, way = hand.place(plant.min(), plant.max()) - from;
    const Sweep sweep = hand.sweep(from, from + 0.4 * way.normalized());
    for (const Pose& X_WG : sweep.ticks(desc.tick_s, 0)) {
      record = lead(world, X_WG);
      audit.move(record.X_WT);
      touched += record.regions > 0 ? 1 : 0;
      ASSERT_EQ(audit.passages(), 0u)
          << audit.first_passage() << " in sweep " << i << " of seed " << hand.kSeed;
      ASSERT_LT(audit.deepest(), 2e-3) << "sweep " << i << " of seed " << hand.kSeed;
      ASSERT_EQ(record.faults & kStoppingFaults, 0u)
          << record.depth_max << " m deep in sweep " << i << " of seed " << hand.kSeed;
    }
  }
  EXPECT_GT(touched, sweeps) << "it was to touch";
}

TEST(Sweep, SpannerPassesNoWall) {
  sweep_walls("spanner", without_edges(spanner_scene()), ContactResponse::constraint, 20);
  sweep_walls("spanner", without_edges(spanner_scene()), ContactResponse::quasi_static, 20);
  sweep_walls("spanner", without_edges(spanner_scene()), ContactResponse::penalty, 20);
}
TEST(Sweep, SpannerPassesNoWallLong) {
  sweep_walls("spanner", without_edges(spanner_scene()), ContactResponse::constraint, 20'000);
  sweep_walls("spanner", without_edges(spanner_scene()), ContactResponse::quasi_static, 20'000);
  sweep_walls("spanner", without_edges(spanner_scene()), ContactResponse::penalty, 20'000);
}

TEST(Sweep, SpannerPassesNoPipe) {
  sweep_pipes(ContactResponse::constraint, 32);
  sweep_pipes(ContactResponse::quasi_static, 32);
  sweep_pipes(ContactResponse::penalty, 32);
}
TEST(Sweep, SpannerPassesNoPipeLong) {
  sweep_pipes(ContactResponse::constraint, 6'000);
  sweep_pipes(ContactResponse::quasi_static, 6'000);
  sweep_pipes(ContactResponse::penalty, 6'000);
}

}  // namespace
}  // namespace fulcrum::test
