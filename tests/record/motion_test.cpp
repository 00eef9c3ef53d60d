#include "engine/record/motion.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <limits>

#include "engine/record/tape_writer.h"
#include "engine/record/trace_writer.h"
#include "synthetic_run.h"

namespace fulcrum::record {
namespace {

constexpr const char* kHeader =
    "timestamp,handle/p/x,handle/p/y,handle/p/z,handle/q/w,handle/q/x,handle/q/y,handle/q/z\n";

bool same(const Pose& a, const Pose& b) {
  return a.p == b.p && a.q.coeffs() == b.q.coeffs();
}

TEST(Motion, OfATapeIsItsSamples) {
  const TemporaryFolder folder;
  Result<TapeWriter> writer = TapeWriter::create(folder / "tape", made_up_header());
  SyntheticRun made_up(1);
  std::vector<DeviceSample> samples;
  for (int i = 0; i < 5; ++i) {
    samples.push_back(made_up.sample());
    writer->entry(samples.back(), {}, i == 3 ? 2 : 0, 0);
  }
  ASSERT_FALSE(writer->flush());
  const Result<HandleMotion> motion = read_motion(folder / "tape");
  ASSERT_TRUE(motion) << motion.error().sentence;
  EXPECT_EQ(motion->space, HandleMotion::Space::device);
  EXPECT_FALSE(motion->complete) << "the tape was never finished";
  const int expected[] = {0, 1, 2, 2, 2, 3, 4};  // the two lost ticks hold sample 2
  ASSERT_EQ(motion->samples.size(), std::size(expected));
  for (std::size_t i = 0; i < std::size(expected); ++i) {
    EXPECT_TRUE(same(motion->samples[i].X_DH, samples[static_cast<std::size_t>(expected[i])].X_DH)) << i;
    EXPECT_EQ(motion->samples[i].strip_ohm, samples[static_cast<std::size_t>(expected[i])].strip_ohm) << i;
  }
}

TEST(Motion, OfATraceIsItsHandleBitForBit) {
  const TemporaryFolder folder;
  Result<TraceWriter> writer =
      TraceWriter::create(folder / "trace.csv", TraceColumns(0.001, {}, {TickRecord()}));
  SyntheticRun made_up(2);
  std::vector<TickRecord> records;
  for (int tick = 0; tick < 100; ++tick) {
    records.push_back(made_up.record(tick));
    writer->row({records.back(), 0});
  }
  ASSERT_FALSE(writer->flush());
  const Result<HandleMotion> motion = read_motion(folder / "trace.csv");
  ASSERT_TRUE(motion) << motion.error().sentence;
  EXPECT_EQ(motion->space, HandleMotion::Space::scene);
  EXPECT_EQ(motion->tick_s, 0.001);
  EXPECT_TRUE(motion->complete);
  ASSERT_EQ(motion->samples.size(), records.size());
  for (std::size_t i = 0; i < records.size(); ++i)
    EXPECT_TRUE(same(motion->samples[i].X_DH, records[i].X_WH)) << i;
}

// What drift has added to the handle's place the hand has not done.
TEST(Motion, OfATraceWithDriftIsTheHandsOwn) {
  const TemporaryFolder folder;
  std::string header = kHeader;
  header.insert(header.size() - 1, ",handle/drift/x,handle/drift/y,handle/drift/z");
  write(folder / "m.csv", header +
                              "0,1,2,3,1,0,0,0,0,0,0\n"
                              "0.001,1,2,3,1,0,0,0,0.5,-0.25,0.125\n");
  const Result<HandleMotion> motion = read_motion(folder / "m.csv");
  ASSERT_TRUE(motion) << motion.error().sentence;
  ASSERT_EQ(motion->samples.size(), 2u);
  EXPECT_EQ(motion->samples[0].X_DH.p, Vec3(1, 2, 3));
  EXPECT_EQ(motion->samples[1].X_DH.p, Vec3(0.5, 2.25, 2.875));
  write(folder / "cut.csv", header + "0,1,2,3,1,0,0,0,0,0,0\n0.001,1,2,3,1,0,0,0,0.5,-0.25\n");
  const Result<HandleMotion> cut = read_motion(folder / "cut.csv");
  ASSERT_FALSE(cut);
  EXPECT_NE(cut.error().sentence.find("handle/drift/z is not a number"), std::string::npos);
}

TEST(Motion, AStripInATraceIsRead) {
  const TemporaryFolder folder;
  std::string header = kHeader;
  header.insert(header.size() - 1, ",holding/strip_ohm");
  write(folder / "m.csv", header +
                              "0,1,0,0,1,0,0,0,5050.25\n"
                              "0.001,1,0,0,1,0,0,0,inf\n"
                              "0.002,1,0,0,1,0,0,0,nan\n"
                              "0.003,1,0,0,1,0,0,0\n");
  const Result<HandleMotion> motion = read_motion(folder / "m.csv");
  ASSERT_TRUE(motion) << motion.error().sentence;
  ASSERT_EQ(motion->samples.size(), 4u);
  EXPECT_EQ(motion->samples[0].strip_ohm, 5050.25);
  EXPECT_EQ(motion->samples[1].strip_ohm, kStripOpen);
  EXPECT_TRUE(std::isnan(motion->samples[2].strip_ohm));
  EXPECT_TRUE(std::isnan(motion->samples[3].strip_ohm));
}

TEST(Motion, AGapHoldsAndARoundedQuaternionIsMadeUnit) {
  const TemporaryFolder folder;
  write(folder / "m.csv", std::string(kHeader) +
                              "0,1,0,0,0.7071,0.7071,0,0\r\n"
                              "0.0005,2,0,0,1,0,0,0\r\n"
                              "0.002,5,0,0,1,0,0,0\r\n");
  const Result<HandleMotion> motion = read_motion(folder / "m.csv");
  ASSERT_TRUE(motion) << motion.error().sentence;
  EXPECT_EQ(motion->tick_s, 0.0005);
  ASSERT_EQ(motion->samples.size(), 5u);
  EXPECT_EQ(motion->samples[3].X_DH.p.x(), 2);
  EXPECT_EQ(motion->samples[4].X_DH.p.x(), 5);
  EXPECT_NEAR(motion->samples[0].X_DH.q.norm(), 1, 1e-15);
}

TEST(Motion, WhatIsWrongIsNamedWithItsLine) {
  const TemporaryFolder folder;
  const std::pair<const char*, const char*> cases[] = {
      {"0,0,0,0,1,0,0,0\n0.001,0,0,zero,1,0,0,0\n", "line 3: handle/p/z is not a number"},
      {"0,0,0,0,1,0,0,0\n0.001,0,0,nan,1,0,0,0\n", "line 3: handle/p/z is not a number"},
      {"0,0,0,0,1,0,0,0\n0.001,0,0,0,1\n", "line 3: handle/q/x is not a number"},
      {"0,0,0,0,2,0,0,0\n", "line 2: handle/q is not a unit quaternion"},
      {"0,0,0,0,1,0,0,0\n0,0,0,0,1,0,0,0\n", "line 3: the timestamp is not after"},
      {"0,0,0,0,1,0,0,0\n", "two ticks at least"},
      {"0,0,0,0,1,0,0,0\n1e-9,0,0,0,1,0,0,0\n1e300,0,0,0,1,0,0,0\n", "ticks are missing"},
      {"-1e308,0,0,0,1,0,0,0\n1e308,0,0,0,1,0,0,0\n", "ticks are missing"},
  };
  for (const auto& [rows, sentence] : cases) {
    write(folder / "m.csv", std::string(kHeader) + rows);
    const Result<HandleMotion> motion = read_motion(folder / "m.csv");
    ASSERT_FALSE(motion) << rows;
    EXPECT_NE(motion.error().sentence.find(sentence), std::string::npos) << motion.error().sentence;
  }
  write(folder / "m.csv", "timestamp,x\n0,1\n");
  EXPECT_NE(read_motion(folder / "m.csv").error().sentence.find("no column handle/p/x"), std::string::npos);
  write(folder / "m.csv", "");
  EXPECT_FALSE(read_motion(folder / "m.csv"));
  EXPECT_FALSE(read_motion(folder / "gone.csv"));
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_NE(read_motion(folder / "pipe").error().sentence.find("it is a pipe"), std::string::npos);
  const std::string row = "0,0,0,0,1,0,0,0\n";
  write(folder / "m.csv", kHeader + row + std::string(1 << 20, ',') + "\n" + row);
  EXPECT_NE(read_motion(folder / "m.csv").error().sentence.find("line 3 is longer"), std::string::npos);
}

TEST(Motion, ATapeThatLostForeverIsRefused) {
  const TemporaryFolder folder;
  Result<TapeWriter> writer = TapeWriter::create(folder / "tape", made_up_header());
  writer->entry(DeviceSample(), {}, 0, 0);
  writer->entry(DeviceSample(), {}, std::numeric_limits<std::int64_t>::max(), 0);
  ASSERT_FALSE(writer->flush());
  EXPECT_FALSE(read_motion(folder / "tape"));
}

}  // namespace
}  // namespace fulcrum::record
