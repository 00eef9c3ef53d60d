// The clumsy hand pushes straight at the goal and twists in place; the expert carries the task out. Both are
// judged on the triangles.

#include <gtest/gtest.h>

#include "engine/app/run/penetration.h"
#include "engine/scenario/task_judge.h"
#include "tests/scenarios/piping/path_audit.h"
#include "tests/scenarios/piping/piping.h"

namespace fulcrum::test {
namespace {

void audit_clumsy(const app::Prepared& prepared, double seconds, double deepest) {
  PipingRun run("clumsy", prepared);
  const scenario::HapticAssembly& haptic = prepared.haptic;
  PathAudit audit(haptic.scene_W, *haptic.scene.tool_shell);
  app::PenetrationMeter meter(haptic.scene.tick_s);
  std::uint32_t faults = 0;
  for (int i = 0; i < static_cast<int>(seconds * 1000); ++i) {
    const TickRecord record = run.tick();
    faults |= record.faults;
    audit.move(record.X_WT);
    meter.note(record);
  }
  EXPECT_GT(audit.crossings(), 1000u) << "it was to touch";
  EXPECT_EQ(audit.passages(), 0u) << audit.first_passage();
  const app::Penetration worst = meter.deepest(haptic.scene_W, haptic.tool_T, haptic.scene.scene_field.get());
  EXPECT_LT(worst.depth, deepest) << "at " << worst.at << " s";
  EXPECT_EQ(faults & kStoppingFaults, 0u);
  // Springs held from tick to tick give out a few millijoules here, and the observer says so.
  EXPECT_EQ((faults & kEnergyBound) != 0, haptic.scene.contact.response == ContactResponse::penalty);
}

// A constraint keeps what lies between the shell's points out as well, but for a part of the voxel.
double of_voxel() {
  return 0.3 * piping().haptic.scene.scene_field->voxel_m();
}
constexpr double kOnSprings = 2e-3;  // m

TEST(Audit, ClumsyHandNeverGetsThroughAPipe) {
  audit_clumsy(piping(), 25, of_voxel());
}
TEST(Audit, ClumsyHandOnSpringsNeverGetsThroughAPipe) {
  audit_clumsy(piping_on_springs(), 25, kOnSprings);
}
TEST(Audit, ClumsyHandNeverGetsThroughAPipeLong) {
  audit_clumsy(piping(), piping().scenario.time_limit, of_voxel());
}
TEST(Audit, ClumsyHandOnSpringsNeverGetsThroughAPipeLong) {
  audit_clumsy(piping_on_springs(), piping().scenario.time_limit, kOnSprings);
}

TEST(Audit, ExpertHandReachesEveryCheckpointInOrder) {
  PipingRun run("expert");
  scenario::TaskJudge judge(piping().haptic.task, piping().haptic.scene.tick_s);
  PathAudit audit(piping().haptic.scene_W, *piping().haptic.scene.tool_shell);
  std::size_t step = 0;
  std::uint32_t faults = 0;
  for (int i = 0; i < 60000 && !judge.state().completed; ++i) {
    const TickRecord record = run.tick();
    faults |= record.faults;
    judge.judge(record);
    audit.move(record.X_WT);
    EXPECT_LE(judge.state().step, step + 1);
    step = judge.state().step;
  }
  EXPECT_TRUE(judge.state().completed);
  EXPECT_LT(audit.deepest(), 0.5e-3);
  EXPECT_EQ(faults & ~kPassivityControl, 0u);
}

}  // namespace
}  // namespace fulcrum::test
