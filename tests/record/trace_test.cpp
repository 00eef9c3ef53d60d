// trace.csv, as scripts rely on it: names, times, numbers, and the hash of what was written.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <array>
#include <nlohmann/json.hpp>

#include "engine/assets/sha256.h"
#include "engine/record/trace_columns.h"
#include "engine/record/trace_reader.h"
#include "engine/record/trace_writer.h"
#include "made_up.h"

namespace fulcrum::record {
namespace {

const std::array<std::string, 3> kArm = {"yaw", "shoulder", "elbow"};

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
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (columns.columns()[i].name == name) {
      return std::string(cells[i]);
    }
  }
  return "no column " + name;
}

TEST(Trace, HeaderIsTheContract) {
  EXPECT_EQ(TraceColumns(1e-3, kArm).header(),
            "timestamp,handle/p/x,handle/p/y,handle/p/z,handle/q/w,handle/q/x,handle/q/y,handle/q/z,"
            "tool/p/x,tool/p/y,tool/p/z,tool/q/w,tool/q/x,tool/q/y,tool/q/z,tool/v/x,tool/v/y,tool/v/z,"
            "tool/w/x,tool/w/y,tool/w/z,coupling/force/x,coupling/force/y,coupling/force/z,"
            "coupling/torque/x,coupling/torque/y,coupling/torque/z,contact/force/x,contact/force/y,"
            "contact/force/z,contact/torque/x,contact/torque/y,contact/torque/z,contact/regions,"
            "contact/depth_max,device/force/x,device/force/y,device/force/z,device/torque/x,device/torque/y,"
            "device/torque/z,actuator/load/yaw,actuator/load/shoulder,actuator/load/elbow,"
            "actuator/missing/force,actuator/missing/torque,task/step,energy/port,energy/unrendered,fault\n");
}

// A task that does not count them keeps its bytes.
TEST(Trace, HardTouchesHaveAColumnWhereTheTaskCountsThem) {
  const TraceColumns without(1e-3, kArm), with(1e-3, kArm, {.hard_touches = true});
  std::string header = with.header();
  const std::string column = "task/hard_touches,";
  ASSERT_NE(header.find(",task/step," + column), std::string::npos);
  EXPECT_EQ(header.erase(header.find(column), column.size()), without.header());
  const TickRecord record;
  std::string line;
  with.append_row(line, {record, 2, 7});
  EXPECT_EQ(split_cells(line)[with.columns().size() - 4], "7");
}

TEST(Trace, ADeviceWithoutMotorsHasNoLoads) {
  EXPECT_EQ(TraceColumns(1e-3, {}).header().find("actuator"), std::string::npos);
}

// What a scene names adds columns, and moves none of the others but for those behind them.
TEST(Trace, TorqueSubstitutionHasColumnsWhereItIsNamed) {
  const std::string without = TraceColumns(1e-3, kArm).header();
  const std::string with =
      TraceColumns(1e-3, kArm, {.torque_substitution = true, .transients = true}).header();
  const std::string added =
      "energy/vibration,torque/bad,torque/magnitude,torque/stiffness,cue/vibration,cue/ghost,"
      "cue/vibration_gain,cue/ghost_gain,";
  const std::size_t at = with.find(added);
  ASSERT_NE(at, std::string::npos) << with;
  EXPECT_EQ(with.substr(0, at) + with.substr(at + added.size()), without);
  TickRecord record;
  record.torque = {.bad = true, .magnitude = 0.125, .vibration = 0.25, .ghost = 0.5, .energy = 1e-6};
  const TraceColumns columns(1e-3, kArm, {.torque_substitution = true, .transients = true});
  EXPECT_EQ(cell(columns, "torque/bad", record), "1");
  EXPECT_EQ(cell(columns, "torque/magnitude", record), "0.125");
  EXPECT_EQ(cell(columns, "cue/vibration", record), "0.25");
  EXPECT_EQ(cell(columns, "cue/ghost", record), "0.5");
  EXPECT_EQ(cell(columns, "energy/vibration", record), "1e-06");
}

TEST(Trace, ImpactsAndTheirVibrationHaveColumnsWhereTheyAreNamed) {
  const std::string without = TraceColumns(1e-3, kArm).header();
  const TraceColumns columns(1e-3, kArm, {.impacts = true, .impact_vibration = true});
  const std::string energy = "energy/impact_vibration,";
  const std::string added =
      "impact/count,impact/speed,impact/object,impact/p/x,impact/p/y,impact/p/z,impact/normal/x,"
      "impact/normal/y,impact/normal/z,vibration/gain,vibration/voices,vibration/dropped,"
      "vibration/frequency_Hz,vibration/radius,vibration/axis/x,vibration/axis/y,vibration/axis/z,"
      "vibration/amplitude/force/x,vibration/amplitude/force/y,vibration/amplitude/force/z,"
      "vibration/amplitude/torque/x,vibration/amplitude/torque/y,vibration/amplitude/torque/z,"
      "vibration/force/x,vibration/force/y,vibration/force/z,vibration/torque/x,vibration/torque/y,"
      "vibration/torque/z,";
  const std::string with = columns.header();
  const std::size_t at = with.find(energy + added);
  ASSERT_NE(at, std::string::npos) << with;
  EXPECT_EQ(with.substr(0, at) + with.substr(at + energy.size() + added.size()), without);
  TickRecord record;
  record.impact.emplace();
  record.impact_vibration.emplace();
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
  EXPECT_EQ(cell(columns, "vibration/frequency_Hz", record), "18.5");
  EXPECT_EQ(cell(columns, "vibration/torque/z", record), "-0.25");
  EXPECT_EQ(cell(columns, "energy/impact_vibration", record), "2e-06");
}

TEST(Trace, TimesAreThoseOnePrints) {
  TickRecord record;
  const TraceColumns kilohertz(0.001, {});
  record.tick = 3;  // 3 * 0.001 is 0.0030000000000000001 and prints so
  EXPECT_EQ(cell(kilohertz, "timestamp", record), "0.003");
  record.tick = 12345;
  EXPECT_EQ(cell(kilohertz, "timestamp", record), "12.345");
  record.tick = 7;
  EXPECT_EQ(cell(TraceColumns(1.0 / 3000, {}), "timestamp", record), "0.0023333333333333335");
  EXPECT_EQ(cell(TraceColumns(0.0035, {}), "timestamp", record), "0.0245");
}

TEST(Trace, EveryColumnShowsItsField) {
  MadeUp made_up(1);
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
  const TraceColumns columns(1e-3, kArm);
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
  const TraceColumns columns(1e-3, kArm);
  const nlohmann::json document = nlohmann::json::parse(columns.json());
  ASSERT_EQ(document["columns"].size(), columns.columns().size());
  EXPECT_EQ(document["version"], 1);
  for (std::size_t i = 0; i < columns.columns().size(); ++i) {
    const nlohmann::json& column = document["columns"][i];
    EXPECT_EQ(column["name"], columns.columns()[i].name);
    EXPECT_FALSE(column["unit"].get<std::string>().empty()) << column;
    EXPECT_TRUE(column["meaning"].get<std::string>().ends_with('.')) << column;
  }
}

TEST(Trace, FileIsHeaderAndRowsAndItsHash) {
  const TemporaryFolder folder;
  const TraceColumns columns(1e-3, kArm);
  Result<TraceWriter> writer = TraceWriter::create(folder / "trace.csv", columns);
  ASSERT_TRUE(writer);
  MadeUp made_up(2);
  std::string expected = columns.header();
  for (int tick = 0; tick < 1000; ++tick) {
    const TickRecord record = made_up.record(tick);
    writer->row({record, 0});
    columns.append_row(expected, {record, 0});
    if (tick % 70 == 0) {
      ASSERT_FALSE(writer->flush());
    }
  }
  ASSERT_FALSE(writer->flush());
  ASSERT_FALSE(writer->close());
  EXPECT_EQ(contents(folder / "trace.csv"), expected);
  EXPECT_EQ(writer->sha256_hex(), *sha256_hex(std::move(*RegularFile::open(folder / "trace.csv"))));
}

TEST(Trace, WhatIsTakenBackIsNeitherInTheFileNorInTheHash) {
  const TemporaryFolder folder;
  const TraceColumns columns(1e-3, {});
  Result<TraceWriter> writer = TraceWriter::create(folder / "trace.csv", columns);
  ASSERT_TRUE(writer);
  MadeUp made_up(3);
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
