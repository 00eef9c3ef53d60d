// Torque substitution in the clumsy hand's run: what it tells, what it may do, and what it leaves alone.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/app/prepare/tape_header.h"
#include "engine/record/trace_reader.h"
#include "tests/scenarios/piping/piping.h"

namespace fulcrum::test {
namespace {

constexpr int kMeasuredTicks = 30000;  // past the first time that the spanner jams

// Bit for bit, by the text of the trace: named but off, against not named.
TEST(Torque, OffLeavesEveryOtherColumnAsItIs) {
  app::Prepared off = prepared_piping({"variant=A"}), none = prepared_piping({});
  none.haptic.scene.torque_substitution.reset();
  const record::TraceColumns of_off =
      app::trace_columns(expect(World::build(off.haptic.scene)), off.haptic.task);
  const record::TraceColumns of_none =
      app::trace_columns(expect(World::build(none.haptic.scene)), none.haptic.task);
  ASSERT_GT(of_off.columns().size(), of_none.columns().size());
  PipingRun a("clumsy", off), b("clumsy", none);
  for (int i = 0; i < 8000; ++i) {
    const TickRecord x = a.tick(), y = b.tick();
    if (i % 10 != 0) continue;
    std::string row_of_off, row_of_none;
    of_off.append_row(row_of_off, {x, 0});
    of_none.append_row(row_of_none, {y, 0});
    const auto with = record::split_cells(row_of_off), without = record::split_cells(row_of_none);
    ASSERT_EQ(without.size(), of_none.columns().size());
    std::size_t place = 0;
    for (std::size_t c = 0; c < without.size(); ++c, ++place) {
      const std::string& name = of_none.columns()[c].name;
      while (place < with.size() && of_off.columns()[place].name != name) ++place;
      ASSERT_LT(place, with.size()) << name;
      ASSERT_EQ(with[place], without[c]) << name << " in tick " << i;
    }
  }
}

struct Depths {
  double good = 0, bad = 0;  // m
  int bad_ticks = 0;
};

Depths clumsy_on_springs(const std::vector<std::string>& overrides) {
  std::vector<std::string> all{"response=penalty"};
  all.insert(all.end(), overrides.begin(), overrides.end());
  const app::Prepared prepared = prepared_piping(all);
  PipingRun run("clumsy", prepared);
  Depths depths;
  for (int i = 0; i < kMeasuredTicks; ++i) {
    const TickRecord record = run.tick();
    double& deepest = record.torque_substitution->bad ? depths.bad : depths.good;
    deepest = std::max(deepest, record.depth_max);
    depths.bad_ticks += record.torque_substitution->bad;
  }
  return depths;
}

// Why the limit is there.
TEST(Torque, UnderSpringsBadTorqueGoesNoDeeperThanGood) {
  const Depths with = clumsy_on_springs({}), without = clumsy_on_springs({"limit_stiffness=false"});
  EXPECT_GT(with.bad_ticks, 1000);
  EXPECT_GT(without.bad_ticks, 1000);
  EXPECT_LE(with.bad, with.good);
  EXPECT_GT(without.bad, 1.5 * with.bad);
}

// The cues come, within the budget of transients, and what the vibration gives to the hand is booked.
TEST(Torque, TheClumsyHandIsTold) {
  PipingRun run("clumsy");
  double vibration = 0, ghost = 0, energy = 0;
  int bad = 0;
  std::uint32_t faults = 0;
  for (int i = 0; i < kMeasuredTicks; ++i) {
    const TickRecord record = run.tick();
    bad += record.torque_substitution->bad;
    vibration = std::max(vibration, record.torque_substitution->vibration);
    ghost = std::max(ghost, record.torque_substitution->ghost);
    energy = std::max(energy, std::abs(record.torque_substitution->energy));
    faults |= record.faults;
  }
  EXPECT_GT(bad, 100);
  EXPECT_GT(vibration, 0.35);
  EXPECT_EQ(ghost, 1.0);
  EXPECT_LT(energy, figures_of(TransientSource::torque_substitution).energy);
  EXPECT_EQ(faults & (kTransientLimited | kEnergyBound), 0u);
}

}  // namespace
}  // namespace fulcrum::test
