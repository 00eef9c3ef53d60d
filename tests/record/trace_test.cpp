// trace.csv, as scripts rely on it: names, times, numbers, and the hash of what was written.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "engine/assets/sha256.h"
#include "engine/record/trace_columns.h"
#include "engine/record/trace_reader.h"
#include "engine/record/trace_writer.h"
#include "synthetic_run.h"

namespace fulcrum::record {
namespace {

const RecordNames kArm = {.motors = {"yaw", "shoulder", "elbow"}};

// Of a scene that names nothing.
TraceColumns plain() {
  return {1e-3, kArm, {TickRecord()}};
}

std::string row_text(const TraceColumns& columns, const TickRecord& record, std::int32_t task_step) {
  std::string line;
  columns.append_row(line, {record, task_step});
  return line;
}

// The cell of a column in the row of a record.
std::string cell(const TraceColumns& columns, const std::string& name, const TickRecord& record,
                 std::int32_t task_step = 0) {
  const std::string line = row_text(columns, record, task_step);
  const std::vector<std::string_view> cells = split_cells(line);
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (columns.columns()[i].name == name) return std::string(cells[i]);
  return "no column " + name;
}

TEST(Trace, HeaderIsTheContract) {
  EXPECT_EQ(
      plain().header(),
      "timestamp,handle/p/x,handle/p/y,handle/p/z,handle/q/w,handle/q/x,handle/q/y,handle/q/z,"
      "tool/p/x,tool/p/y,tool/p/z,tool/q/w,tool/q/x,tool/q/y,tool/q/z,tool/v/x,tool/v/y,tool/v/z,"
      "tool/w/x,tool/w/y,tool/w/z,coupling/force/x,coupling/force/y,coupling/force/z,"
      "coupling/torque/x,coupling/torque/y,coupling/torque/z,contact/force/x,contact/force/y,"
      "contact/force/z,contact/torque/x,contact/torque/y,contact/torque/z,contact/regions,"
      "contact/depth_max,device/force/x,device/force/y,device/force/z,device/torque/x,device/torque/y,"
      "device/torque/z,actuator/load/yaw,actuator/load/shoulder,actuator/load/elbow,"
      "actuator/shortfall/force,actuator/shortfall/torque,energy/port,energy/unrendered,fault,task/step\n");
}

// A task that does not count them keeps its bytes.
TEST(Trace, HardTouchesHaveAColumnWhereTheTaskCountsThem) {
  const TickRecord record;
  const TraceColumns without = plain(), with(1e-3, kArm, {record, 0, 0});
  std::string header = with.header();
  const std::string column = "task/hard_touches";
  ASSERT_TRUE(header.ends_with(",task/step," + column + '\n'));
  EXPECT_EQ(header.erase(header.size() - column.size() - 2, column.size() + 1), without.header());
  std::string line;
  with.append_row(line, {record, 2, 7});
  EXPECT_TRUE(line.ends_with(",2,7\n")) << line;
}

TEST(Trace, ADeviceWithoutMotorsHasNoLoads) {
  EXPECT_EQ(TraceColumns(1e-3, {}, {TickRecord()}).header().find("actuator"), std::string::npos);
}

// What a scene names adds columns, and moves none of the others but for those behind them.
void expect_added(const TraceColumns& with, const std::string& added) {
  const std::string header = with.header();
  const std::size_t at = header.find(added);
  ASSERT_NE(at, std::string::npos) << header;
  EXPECT_EQ(header.substr(0, at) + header.substr(at + added.size()), plain().header());
}

TEST(Trace, TorqueSubstitutionHasColumnsWhereItIsNamed) {
  TickRecord record;
  record.torque_substitution = {
      .bad = true, .magnitude = 0.125, .vibration = 0.25, .ghost = 0.5, .energy = 1e-6};
  const TraceColumns columns(1e-3, kArm, {record});
  expect_added(columns,
               "torque_substitution/bad,torque_substitution/magnitude,torque_substitution/stiffness,"
               "torque_substitution/vibration,torque_substitution/ghost,torque_substitution/vibration_gain,"
               "torque_substitution/ghost_gain,torque_substitution/energy,");
  EXPECT_EQ(cell(columns, "torque_substitution/bad", record), "1");
  EXPECT_EQ(cell(columns, "torque_substitution/magnitude", record), "0.125");
  EXPECT_EQ(cell(columns, "torque_substitution/vibration", record), "0.25");
  EXPECT_EQ(cell(columns, "torque_substitution/ghost", record), "0.5");
  EXPECT_EQ(cell(columns, "torque_substitution/energy", record), "1e-06");
}

TEST(Trace, ImpactsAndTheirVibrationHaveColumnsWhereTheyAreNamed) {
  TickRecord record;
  record.impact.emplace();
  record.impact_vibration.emplace();
  const TraceColumns columns(1e-3, kArm, {record});
  expect_added(columns,
               "impact/count,impact/speed,impact/object,impact/p/x,impact/p/y,impact/p/z,impact/normal/x,"
               "impact/normal/y,impact/normal/z,impact_vibration/gain,impact_vibration/voices,"
               "impact_vibration/dropped,impact_vibration/frequency_Hz,impact_vibration/radius,"
               "impact_vibration/axis/x,impact_vibration/axis/y,impact_vibration/axis/z,"
               "impact_vibration/amplitude/force/x,impact_vibration/amplitude/force/y,"
               "impact_vibration/amplitude/force/z,impact_vibration/amplitude/torque/x,"
               "impact_vibration/amplitude/torque/y,impact_vibration/amplitude/torque/z,"
               "impact_vibration/force/x,impact_vibration/force/y,impact_vibration/force/z,"
               "impact_vibration/torque/x,impact_vibration/torque/y,impact_vibration/torque/z,"
               "impact_vibration/energy,");
  EXPECT_EQ(cell(columns, "impact/object", record), "-1");
  record.impact->count = 2;
  record.impact->hardest.object = 3;
  record.impact->hardest.speed = 0.125;
  record.impact_vibration->frequency_Hz = 18.5;
  record.impact_vibration->F_H_D.torque.z() = -0.25;
  record.impact_vibration->energy = 2e-6;
  EXPECT_EQ(cell(columns, "impact/count", record), "2");
  EXPECT_EQ(cell(columns, "impact/object", record), "3");
  EXPECT_EQ(cell(columns, "impact/speed", record), "0.125");
  EXPECT_EQ(cell(columns, "impact_vibration/frequency_Hz", record), "18.5");
  EXPECT_EQ(cell(columns, "impact_vibration/torque/z", record), "-0.25");
  EXPECT_EQ(cell(columns, "impact_vibration/energy", record), "2e-06");
}

TEST(Trace, EachChannelHasAColumn) {
  TickRecord record;
  record.vibrotactile_motion.emplace().command.level = {0.5, 0.25};
  const TraceColumns columns(1e-3, {.channels = {"left", "right"}}, {record});
  EXPECT_EQ(cell(columns, "vibrotactile_motion/level/left", record), "0.5");
  EXPECT_EQ(cell(columns, "vibrotactile_motion/level/right", record), "0.25");
}

// Each cell under its own name, for all that a record can have.
TEST(Trace, ARowHasACellForEachColumn) {
  TickRecord record;
  record.impact.emplace();
  record.holding.emplace();
  record.contact_stiffness = record.contact_stiffness_wanted = 300;
  record.torque_substitution.emplace();
  record.impact_vibration.emplace();
  record.braking_pulse.emplace();
  record.vibrotactile_motion.emplace();
  record.inertia_compensation.emplace();
  const TraceColumns columns(1e-3, {.motors = kArm.motors, .channels = {"left", "right"}}, {record, 0, 0});
  EXPECT_EQ(split_cells(row_text(columns, record, 0)).size(), columns.columns().size() - 1);
  std::string line;
  columns.append_row(line, {record, 0, 0});
  EXPECT_EQ(split_cells(line).size(), columns.columns().size());
  std::set<std::string> names;
  for (const TraceColumn& column : columns.columns())
    EXPECT_TRUE(names.insert(column.name).second) << column.name;
}

TEST(Trace, TimesAreThoseOnePrints) {
  TickRecord record;
  const TraceColumns kilohertz(0.001, {}, {record});
  record.tick = 3;  // 3 * 0.001 is 0.0030000000000000001 and prints so
  EXPECT_EQ(cell(kilohertz, "timestamp", record), "0.003");
  record.tick = 12345;
  EXPECT_EQ(cell(kilohertz, "timestamp", record), "12.345");
  record.tick = 7;
  EXPECT_EQ(cell(TraceColumns(1.0 / 3000, {}, {record}), "timestamp", record), "0.0023333333333333335");
  EXPECT_EQ(cell(TraceColumns(0.0035, {}, {record}), "timestamp", record), "0.0245");
}

TEST(Trace, EveryColumnShowsItsField) {
  SyntheticRun made_up(1);
  TickRecord r = made_up.record(5);
  r.X_WH.q = Quat(0.5, -0.5, 0.5, -0.5);
  r.X_WT.p.y() = -0.25;
  r.V_WT.w.z() = 11;
  r.coupling_F_T_W.torque.x() = -0.0;
  r.contact_F_T_W.force.z() = 1e-9;
  r.regions = 4;
  r.depth_max = 0.00025;
  r.device_F_H_D.torque.y() = 0.125;
  r.actuator_load[1] = -0.75;
  r.energy_port = -1e-4;
  r.faults = 0x80000001u;
  const TraceColumns columns = plain();
  EXPECT_EQ(cell(columns, "handle/q/w", r), "0.5");
  EXPECT_EQ(cell(columns, "handle/q/z", r), "-0.5");
  EXPECT_EQ(cell(columns, "tool/p/y", r), "-0.25");
  EXPECT_EQ(cell(columns, "tool/w/z", r), "11");
  EXPECT_EQ(cell(columns, "coupling/torque/x", r), "0");
  EXPECT_EQ(cell(columns, "contact/force/z", r), "1e-09");
  EXPECT_EQ(cell(columns, "contact/regions", r), "4");
  EXPECT_EQ(cell(columns, "contact/depth_max", r), "0.00025");
  EXPECT_EQ(cell(columns, "device/torque/y", r), "0.125");
  EXPECT_EQ(cell(columns, "actuator/load/shoulder", r), "-0.75");
  EXPECT_EQ(cell(columns, "task/step", r, 2), "2");
  EXPECT_EQ(cell(columns, "energy/port", r), "-1e-04");
  EXPECT_EQ(cell(columns, "fault", r), "2147483649");
}

TEST(Trace, JsonTellsOfEveryColumn) {
  const TraceColumns columns = plain();
  const nlohmann::json document = nlohmann::json::parse(columns.json());
  ASSERT_EQ(document["columns"].size(), columns.columns().size());
  EXPECT_EQ(document["version"], kTraceVersion);
  for (std::size_t i = 0; i < columns.columns().size(); ++i) {
    const nlohmann::json& column = document["columns"][i];
    EXPECT_EQ(column["name"], columns.columns()[i].name);
    EXPECT_FALSE(column["unit"].get<std::string>().empty()) << column;
    EXPECT_TRUE(column["meaning"].get<std::string>().ends_with('.')) << column;
  }
}

TEST(Trace, FileIsHeaderAndRowsAndItsHash) {
  const TemporaryFolder folder;
  const TraceColumns columns = plain();
  Result<TraceWriter> writer = TraceWriter::create(folder / "trace.csv", columns);
  ASSERT_TRUE(writer);
  SyntheticRun made_up(2);
  std::string expected = columns.header();
  for (int tick = 0; tick < 1000; ++tick) {
    const TickRecord record = made_up.record(tick);
    writer->row({record, 0});
    columns.append_row(expected, {record, 0});
    if (tick % 70 == 0) ASSERT_FALSE(writer->flush());
  }
  ASSERT_FALSE(writer->flush());
  ASSERT_FALSE(writer->close());
  EXPECT_EQ(contents(folder / "trace.csv"), expected);
  EXPECT_EQ(writer->sha256_hex(), *sha256_hex(std::move(*RegularFile::open(folder / "trace.csv"))));
}

TEST(Trace, WhatIsTakenBackIsNeitherInTheFileNorInTheHash) {
  const TemporaryFolder folder;
  const TraceColumns columns(1e-3, {}, {TickRecord()});
  Result<TraceWriter> writer = TraceWriter::create(folder / "trace.csv", columns);
  ASSERT_TRUE(writer);
  SyntheticRun made_up(3);
  const TickRecord kept = made_up.record(0), dropped = made_up.record(1);
  writer->row({kept, 0});
  ASSERT_FALSE(writer->flush());
  writer->row({dropped, 0});
  ASSERT_FALSE(writer->flush());
  writer->take_back();
  EXPECT_EQ(contents(folder / "trace.csv"), columns.header() + row_text(columns, kept, 0));
  EXPECT_EQ(writer->sha256_hex(), *sha256_hex(std::move(*RegularFile::open(folder / "trace.csv"))));
}

TEST(Trace, ReaderPassesOverALineThatWasCutOff) {
  const TemporaryFolder folder;
  write(folder / "trace.csv", "a,b\n1,2\n3,4\n5,");
  Result<TraceReader> reader = TraceReader::open(folder / "trace.csv");
  ASSERT_TRUE(reader);
  int rows = 0;
  while (reader->next()) {
    ++rows;
    EXPECT_EQ(reader->cells().size(), 2u);
  }
  EXPECT_EQ(rows, 2);
  EXPECT_FALSE(reader->complete());
}

TEST(Trace, ReaderRefusesWhatIsNoFile) {
  EXPECT_FALSE(TraceReader::open("/dev/zero"));
  EXPECT_FALSE(TraceReader::open("/nowhere/trace.csv"));
  const TemporaryFolder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_EQ(TraceReader::open(folder / "pipe").error().sentence,
            "Cannot read " + (folder / "pipe").string() +
                ": it is a pipe, not a file. Check the path and its permissions.");
}

// Each comma is a cell: a line without bounds would fill the memory.
TEST(Trace, ReaderRefusesALineWithoutEnd) {
  const TemporaryFolder folder;
  const std::string commas(1 << 20, ',');
  write(folder / "trace.csv", commas);
  const Result<TraceReader> header = TraceReader::open(folder / "trace.csv");
  ASSERT_FALSE(header);
  EXPECT_NE(header.error().sentence.find("trace.csv: line 1 is longer than 65536 bytes. Name a trace.csv"),
            std::string::npos)
      << header.error().sentence;
  write(folder / "trace.csv", "a,b\n1,2\n" + commas + "\n3,4\n");
  Result<TraceReader> row = TraceReader::open(folder / "trace.csv");
  ASSERT_TRUE(row);
  EXPECT_TRUE(row->next());
  EXPECT_FALSE(row->next());
  EXPECT_FALSE(row->complete());
  ASSERT_TRUE(row->fault());
  EXPECT_NE(row->fault()->sentence.find("line 3"), std::string::npos);
}

}  // namespace
}  // namespace fulcrum::record
