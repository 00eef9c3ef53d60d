// What a recorder leaves behind: a run that ended, one that was killed, and one whose disk was full.
#include "engine/record/recorder.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "engine/assets/sha256.h"
#include "engine/record/digest.h"
#include "engine/record/tape_reader.h"
#include "engine/record/trace_reader.h"
#include "haptics/safety/faults.h"
#include "synthetic_run.h"

namespace fulcrum::record {
namespace {

TraceColumns columns() {
  return {1e-3, {.motors = {"x", "y", "z"}}, {TickRecord()}};
}

std::int64_t rows_in(const std::filesystem::path& csv) {
  Result<TraceReader> reader = TraceReader::open(csv);
  std::int64_t rows = 0;
  while (reader && reader->next()) {
    EXPECT_EQ(reader->cells().size(), reader->names().size());
    ++rows;
  }
  return rows;
}

// Ticks [from, to) of the same made-up run, whichever way it is cut into calls.
void run_ticks(Recorder& recorder, std::int64_t from, std::int64_t to) {
  const Command stop{Command::Kind::stop};
  for (std::int64_t tick = from; tick < to; ++tick) {
    SyntheticRun made_up(static_cast<std::uint64_t>(tick));
    const TickRecord record = made_up.record(tick);
    const DeviceSample sample = made_up.sample();
    recorder.tick({.record = record,
                   .sample = sample,
                   .commands = std::span(&stop, tick % 100 == 0 ? 1 : 0),
                   .task_step = static_cast<std::int32_t>(tick / 1000),
                   .cpu_ns = 12345});
  }
}

// All files tell of the same ticks, from the first on. Returns how many.
std::int64_t expect_agreement(const std::filesystem::path& folder) {
  const Result<Tape> tape = read_tape(folder / "tape");
  EXPECT_TRUE(tape) << tape.error().sentence;
  const std::int64_t rows = rows_in(folder / "trace.csv");
  EXPECT_EQ(rows, std::ssize(tape->entries));
  EXPECT_EQ(rows, rows_in(folder / "timing.csv"));
  for (std::size_t i = 0; i < tape->entries.size(); ++i)
    EXPECT_EQ(tape->entries[i].digest, digest(SyntheticRun(i).record(static_cast<std::int64_t>(i))));
  return rows;
}

TEST(Recorder, LeavesTheWholeRun) {
  const TemporaryFolder folder;
  Result<Recorder> recorder = Recorder::begin(folder.path(), made_up_header(), columns());
  ASSERT_TRUE(recorder) << recorder.error().sentence;
  run_ticks(*recorder, 0, 1234);
  const Recorder::Outcome outcome = recorder->finish();
  EXPECT_EQ(outcome.rows, 1234);
  EXPECT_TRUE(outcome.complete);
  EXPECT_FALSE(recorder->take_error());
  EXPECT_EQ(outcome.trace_sha256, *sha256_hex(std::move(*RegularFile::open(folder / "trace.csv"))));
  EXPECT_EQ(expect_agreement(folder.path()), 1234);
  EXPECT_TRUE(read_tape(folder / "tape")->complete);
  EXPECT_EQ(contents(folder / "trace.json"), columns().json());
  EXPECT_TRUE(
      contents(folder / "timing.csv").starts_with("tick,cpu_us,wake_late_us,lost_before\n0,12.345,0,0\n"));
  EXPECT_FALSE(std::filesystem::exists(folder / "flight.csv"));
}

TEST(Recorder, ARunWithoutTicksIsARun) {
  const TemporaryFolder folder;
  Result<Recorder> recorder = Recorder::begin(folder.path(), made_up_header(), columns());
  ASSERT_TRUE(recorder);
  EXPECT_TRUE(recorder->finish().complete);
  EXPECT_EQ(expect_agreement(folder.path()), 0);
}

TEST(Recorder, OverwritesNothing) {
  for (const char* name : {"trace.csv", "tape", "timing.csv", "trace.json"}) {
    const TemporaryFolder folder;
    write(folder / name, "old");
    const Result<Recorder> recorder = Recorder::begin(folder.path(), made_up_header(), columns());
    ASSERT_FALSE(recorder);
    EXPECT_NE(recorder.error().sentence.find("--force"), std::string::npos) << recorder.error().sentence;
    EXPECT_EQ(contents(folder / name), "old");
  }
}

TEST(Recorder, FlushesByTicksAndByTheClock) {
  const TemporaryFolder folder;
  const TraceColumns slow(0.01, {}, {TickRecord()});  // 25 ticks are 0.25 s
  Result<Recorder> recorder = Recorder::begin(folder.path(), made_up_header(), slow);
  ASSERT_TRUE(recorder);
  run_ticks(*recorder, 0, 24);
  EXPECT_EQ(rows_in(folder / "trace.csv"), 0);
  run_ticks(*recorder, 24, 27);
  EXPECT_EQ(expect_agreement(folder.path()), 25);
  const Recorder::Clock::time_point start{};
  recorder->flush_if_due(start);
  recorder->flush_if_due(start + std::chrono::milliseconds(499));
  EXPECT_EQ(expect_agreement(folder.path()), 25);
  recorder->flush_if_due(start + std::chrono::milliseconds(500));
  EXPECT_EQ(expect_agreement(folder.path()), 27);
}

// The child ticks in real time and tells, after each tick, how far it is; then it is killed without a
// warning.
TEST(Recorder, KilledLosesNoMoreThanASecond) {
  const TemporaryFolder folder;
  int told[2];
  ASSERT_EQ(::pipe(told), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    Result<Recorder> recorder = Recorder::begin(folder.path(), made_up_header(), columns());
    for (std::int64_t tick = 0; recorder; ++tick) {
      run_ticks(*recorder, tick, tick + 1);
      recorder->flush_if_due(Recorder::Clock::now());
      if (::write(told[1], &tick, sizeof tick) != sizeof tick) break;
    }
    ::_exit(1);
  }
  ::close(told[1]);
  std::int64_t last = -1;
  while (last < 3777 && ::read(told[0], &last, sizeof last) == sizeof last) {
  }
  ::kill(child, SIGKILL);
  for (std::int64_t tick; ::read(told[0], &tick, sizeof tick) == sizeof tick;)
    last = tick;  // what was in the pipe still
  ::close(told[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status));

  const Result<Tape> tape = read_tape(folder / "tape");
  ASSERT_TRUE(tape) << tape.error().sentence;
  EXPECT_FALSE(tape->complete);
  const std::int64_t rows = rows_in(folder / "trace.csv");
  EXPECT_GE(rows, last - 1000);
  // The files are written one after the other, the tape last: a kill in between leaves it one block behind.
  EXPECT_GE(rows, std::ssize(tape->entries));
  EXPECT_LE(rows, std::ssize(tape->entries) + 250);
  EXPECT_GE(std::ssize(tape->entries), last - 1000);
}

// Runs until the files cannot grow; everything must agree, and the sentence come once.
void expect_stop_at_full_disk(const std::filesystem::path& folder, const char* remedy) {
  Result<Recorder> recorder = Recorder::begin(folder, made_up_header(), columns());
  ASSERT_TRUE(recorder) << recorder.error().sentence;
  std::int64_t tick = 0;
  std::optional<Error> error;
  while (!error && tick < 20000) {
    run_ticks(*recorder, tick, tick + 10);
    tick += 10;
    error = recorder->take_error();
  }
  ASSERT_TRUE(error);
  EXPECT_NE(error->sentence.find(remedy), std::string::npos) << error->sentence;
  run_ticks(*recorder, tick, tick + 1000);  // the run goes on
  EXPECT_FALSE(recorder->take_error());
  const Recorder::Outcome outcome = recorder->finish();
  EXPECT_FALSE(recorder->take_error());
  EXPECT_FALSE(outcome.complete);
  EXPECT_EQ(outcome.rows, expect_agreement(folder));
  EXPECT_GT(outcome.rows, 0);
  EXPECT_TRUE(contents(folder / "trace.csv").ends_with('\n'));
  EXPECT_EQ(outcome.trace_sha256, *sha256_hex(std::move(*RegularFile::open(folder / "trace.csv"))));
  EXPECT_FALSE(read_tape(folder / "tape")->complete);
}

TEST(Recorder, StopsAtTheLimitOfAFilesSize) {
  const TemporaryFolder folder;
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = ::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{300'000, before.rlim_max};
  ::setrlimit(RLIMIT_FSIZE, &limit);
  expect_stop_at_full_disk(folder.path(), "ulimit -f");
  ::setrlimit(RLIMIT_FSIZE, &before);
  ::signal(SIGXFSZ, handler);
}

// Every size of disk fills up at another write: trace, timing or tape, header or block.
TEST(Recorder, StopsAtAFullDiskWhereverItIsFull) {
  const TemporaryFolder folder;
  for (int size_KiB = 180; size_KiB < 340; size_KiB += 4) {
    const std::string options = "size=" + std::to_string(size_KiB) + "k";
    if (::mount("fulcrum-test", folder.path().c_str(), "tmpfs", 0, options.c_str()) != 0)
      GTEST_SKIP() << "mounting needs root";
    expect_stop_at_full_disk(folder.path(), "the disk is full");
    ASSERT_EQ(::umount(folder.path().c_str()), 0);
  }
}

TEST(Recorder, AFolderThatIsFullFromTheStartIsASentence) {
  const TemporaryFolder folder;
  if (::mount("fulcrum-test", folder.path().c_str(), "tmpfs", 0, "size=64k") != 0)
    GTEST_SKIP() << "mounting needs root";
  write(folder / "filler", std::string(64 * 1024, 'x'));
  const Result<Recorder> recorder = Recorder::begin(folder.path(), made_up_header(), columns());
  EXPECT_FALSE(recorder);
  if (!recorder) {
    EXPECT_NE(recorder.error().sentence.find("the disk is full"), std::string::npos)
        << recorder.error().sentence;
  }
  ASSERT_EQ(::umount(folder.path().c_str()), 0);
}

void run_with_fault(Recorder& recorder, std::int64_t ticks, std::int64_t fault_tick, std::uint32_t bits) {
  for (std::int64_t tick = 0; tick < ticks; ++tick) {
    TickRecord record;
    record.tick = tick;
    record.faults = tick == fault_tick ? bits : 0;
    recorder.tick({.record = record, .sample = DeviceSample(), .commands = {}, .task_step = 3});
  }
}

TEST(Recorder, AFaultLeavesWhatLedToItAndWhatCameOfIt) {
  const TemporaryFolder folder;
  Result<Recorder> recorder = Recorder::begin(folder.path(), made_up_header(), columns());
  ASSERT_TRUE(recorder);
  run_with_fault(*recorder, 9000, 4000, kDeviceLost);
  EXPECT_TRUE(recorder->finish().complete);
  const std::string flight = contents(folder / "flight.csv"), trace = contents(folder / "trace.csv");
  EXPECT_EQ(rows_in(folder / "flight.csv"), 2000);
  const std::string rows = flight.substr(flight.find('\n') + 1);
  EXPECT_TRUE(flight.starts_with(columns().header() + "2.501,"));
  EXPECT_NE(trace.find('\n' + rows), std::string::npos) << "the same rows as in the trace";
}

TEST(Recorder, AFaultAtTheEndIsInTheFlightToo) {
  const TemporaryFolder folder;
  Result<Recorder> recorder = Recorder::begin(folder.path(), made_up_header(), columns());
  ASSERT_TRUE(recorder);
  run_with_fault(*recorder, 100, 99, kNotFinite);
  recorder->finish();
  EXPECT_EQ(contents(folder / "flight.csv"), contents(folder / "trace.csv"));
}

TEST(Recorder, ALimitIsNoFault) {
  const TemporaryFolder folder;
  Result<Recorder> recorder = Recorder::begin(folder.path(), made_up_header(), columns());
  ASSERT_TRUE(recorder);
  run_with_fault(*recorder, 3000, 1000, kForceClamped);
  recorder->finish();
  EXPECT_FALSE(std::filesystem::exists(folder / "flight.csv"));
}

}  // namespace
}  // namespace fulcrum::record
