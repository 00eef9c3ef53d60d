// The clumsy hand pushes straight at the goal and twists in place; the expert carries the task out. Both are
// judged on the triangles.

#include <gtest/gtest.h>

#include "engine/scenario/task_judge.h"
#include "tests/piping/path_audit.h"
#include "tests/piping/piping.h"

namespace fulcrum::test {
namespace {

void audit_clumsy(double seconds) {
  PipingRun run("clumsy");
  PathAudit audit(piping().haptic.scene_W, *piping().haptic.scene.tool_shell);
  std::uint32_t faults = 0;
  for (int i = 0; i < static_cast<int>(seconds * 1000); ++i) {
    const TickRecord record = run.tick();
    faults |= record.faults;
    audit.move(record.X_WT);
  }
  EXPECT_GT(audit.crossings(), 1000u) << "it was to touch";
  EXPECT_EQ(audit.passages(), 0u) << audit.first_passage();
  EXPECT_LT(audit.deepest(), 2e-3);
  EXPECT_EQ(faults & (kStoppingFaults | kEnergyBound), 0u);
}

TEST(Audit, ClumsyHandNeverGetsThroughAPipe) {
  audit_clumsy(25);
}
TEST(Audit, ClumsyHandNeverGetsThroughAPipeLong) {
  audit_clumsy(piping().scenario.time_limit);
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
