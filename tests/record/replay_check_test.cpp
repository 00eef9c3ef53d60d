// The digest sees every field of a record, and a replay that parts from its run says when and in what.
#include "engine/record/replay_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>

#include "engine/record/digest.h"
#include "engine/record/trace_writer.h"
#include "synthetic_run.h"

namespace fulcrum::record {
namespace {

TEST(Digest, SeesEveryField) {
  const TickRecord original = SyntheticRun(1).record(3);
  const std::vector<std::function<void(TickRecord&)>> changes = {
      [](TickRecord& r) { r.tick = 4; },
      [](TickRecord& r) { r.X_WH.q.w() = std::nextafter(r.X_WH.q.w(), 2); },
      [](TickRecord& r) { r.X_WH.p.z() *= 1 + 1e-15; },
      [](TickRecord& r) { r.X_WT.q.z() *= -1; },
      [](TickRecord& r) { r.X_WT.p.x() = 0; },
      [](TickRecord& r) { r.V_WT.v.y() = 0; },
      [](TickRecord& r) { r.V_WT.w.y() = 0; },
      [](TickRecord& r) { r.coupling_F_T_W.force.x() = 0; },
      [](TickRecord& r) { r.coupling_F_T_W.torque.x() = 0; },
      [](TickRecord& r) { r.contact_F_T_W.force.x() = 0; },
      [](TickRecord& r) { r.contact_F_T_W.torque.x() = 0; },
      [](TickRecord& r) { r.regions += 1; },
      [](TickRecord& r) { r.depth_max = 0; },
      [](TickRecord& r) { r.device_F_H_D.force.x() = 0; },
      [](TickRecord& r) { r.device_F_H_D.torque.x() = 0; },
      [](TickRecord& r) { r.actuator_load.back() = 0; },
      [](TickRecord& r) { r.energy_port = 0; },
      [](TickRecord& r) { r.force_gain = 0.5; },
      [](TickRecord& r) { r.faults = 1; },
      [](TickRecord& r) { r.stopped = true; },
      [](TickRecord& r) { r.clutched = true; },
  };
  std::set<std::uint64_t> seen = {digest(original)};
  for (std::size_t i = 0; i < changes.size(); ++i) {
    TickRecord changed = original;
    changes[i](changed);
    EXPECT_TRUE(seen.insert(digest(changed)).second) << "change " << i;
  }
}

TEST(Digest, SeesNoPadding) {
  // The same values in memory that was filled differently before.
  alignas(TickRecord) unsigned char storage[2][sizeof(TickRecord)];
  std::fill(std::begin(storage[0]), std::end(storage[0]), 0x00);
  std::fill(std::begin(storage[1]), std::end(storage[1]), 0xff);
  const TickRecord original = SyntheticRun(1).record(3);
  const TickRecord* const a = new (storage[0]) TickRecord(original);
  const TickRecord* const b = new (storage[1]) TickRecord(original);
  EXPECT_EQ(digest(*a), digest(*b));
}

class Replay : public testing::Test {
protected:
  Replay() {
    Result<TraceWriter> trace = TraceWriter::create(folder_ / "trace.csv", columns_);
    SyntheticRun made_up(5);
    for (int tick = 0; tick < 10; ++tick) {
      run_.push_back(made_up.record(tick));
      trace->row({run_.back(), 0});
    }
    EXPECT_FALSE(trace->flush());
  }

  ReplayCheck check(const std::vector<TickRecord>& replay) const {
    ReplayCheck check;
    for (std::size_t i = 0; i < replay.size(); ++i) check.tick({replay[i], 0}, digest(run_[i]));
    return check;
  }

  TemporaryFolder folder_;
  TraceColumns columns_{1e-3, {}, {TickRecord()}};
  std::vector<TickRecord> run_;
};

TEST_F(Replay, OfTheSameIsTheSame) {
  EXPECT_TRUE(check(run_).same());
  EXPECT_EQ(check(run_).ticks(), 10);
}

TEST_F(Replay, NamesTickAndColumnAndValues) {
  std::vector<TickRecord> replay = run_;
  run_[6].contact_F_T_W.force.y() = 1.25;
  replay[6].contact_F_T_W.force.y() = 1.5;
  replay[8].tick = 99;  // later, and not the one to name
  std::filesystem::remove(folder_ / "trace.csv");
  Result<TraceWriter> trace = TraceWriter::create(folder_ / "trace.csv", columns_);
  for (const TickRecord& record : run_) trace->row({record, 0});
  ASSERT_FALSE(trace->flush());
  const ReplayCheck differing = check(replay);
  ASSERT_FALSE(differing.same());
  EXPECT_EQ(differing.divergence(columns_, folder_ / "trace.csv"),
            "The replay differs from the run from tick 6 on (0.006 s): contact/force/y was 1.25 and is 1.5.");
}

TEST_F(Replay, SaysWhenTheTraceDoesNotShowIt) {
  std::vector<TickRecord> replay = run_;
  replay[2].force_gain = 0.5;
  EXPECT_EQ(
      check(replay).divergence(columns_, folder_ / "trace.csv"),
      "The replay differs from the run from tick 2 on (0.002 s), in a value that the trace does not show.");
}

TEST_F(Replay, SaysWhenThereIsNoTrace) {
  std::vector<TickRecord> replay = run_;
  replay[2].tick = 3;
  const std::string sentence = check(replay).divergence(columns_, folder_ / "gone.csv");
  EXPECT_NE(sentence.find("cannot be read"), std::string::npos) << sentence;
}

}  // namespace
}  // namespace fulcrum::record
