#include "engine/record/motion.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>

#include "engine/files/file_error.h"
#include "engine/files/regular_file.h"
#include "engine/record/tape_reader.h"
#include "engine/record/trace_reader.h"
#include "engine/record/whole_rate.h"

namespace fulcrum::record {

namespace {

// Ticks that may be filled in for lost ones: a damaged time must not fill the memory.
constexpr std::int64_t kMaxLost = 1'000'000;

// The tick and the seven numbers of a pose, by name.
constexpr std::array<const char*, 8> kColumns = {"timestamp",  "handle/p/x", "handle/p/y", "handle/p/z",
                                                 "handle/q/w", "handle/q/x", "handle/q/y", "handle/q/z"};
// By which drift has carried the handle on, where a run had drift: the hand has not.
constexpr std::array<const char*, 3> kDriftColumns = {"handle/drift/x", "handle/drift/y", "handle/drift/z"};
// The second in a trace of version 1.
constexpr std::array<const char*, 2> kStripColumns = {"holding_point/strip_ohm", "holding/strip_ohm"};

struct TimedSample {
  double time = 0;  // s
  DeviceSample sample;
};

Error too_many_lost(const std::filesystem::path& path) {
  return {path.string() + ": more than " + std::to_string(kMaxLost) +
          " ticks are missing in between. Cut the file where the motion stops."};
}

Result<HandleMotion> motion_of_tape(const std::filesystem::path& path) {
  const Result<Tape> tape = read_tape(path);
  if (!tape) return tape.error();
  if (tape->entries.empty())
    return Error{path.string() + ": the tape has no ticks on it. Record a longer run."};
  HandleMotion motion;
  motion.tick_s = tape->header.tick_s;
  motion.complete = tape->complete;
  std::int64_t lost = 0;
  for (const TapeEntry& entry : tape->entries) {
    if (!motion.samples.empty()) {
      if (entry.lost_before > kMaxLost - lost) return too_many_lost(path);
      lost += entry.lost_before;
      motion.samples.insert(motion.samples.end(), static_cast<std::size_t>(entry.lost_before),
                            DeviceSample(motion.samples.back()));
    }
    motion.samples.push_back(entry.sample);
  }
  return motion;
}

std::optional<double> number(std::string_view cell) {
  double value = 0;
  const auto [end, failure] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  const bool whole = failure == std::errc() && end == cell.data() + cell.size() && std::isfinite(value);
  return whole ? std::optional(value) : std::nullopt;
}

// Where the columns are that a motion needs, and those of drift and of a strip if there are such.
struct Places {
  std::array<std::size_t, kColumns.size()> pose{};
  std::array<std::optional<std::size_t>, kDriftColumns.size()> drift{};
  std::optional<std::size_t> strip;
};

// ohm; any number, and no number at all is no strip.
double strip_of(std::span<const std::string_view> cells, const std::optional<std::size_t>& where) {
  double ohm = kNoStrip;
  if (where && *where < cells.size())
    std::from_chars(cells[*where].data(), cells[*where].data() + cells[*where].size(), ohm);
  return ohm;
}

// One row, or a sentence without its place.
Result<TimedSample> sample_of_row(std::span<const std::string_view> cells, const Places& places) {
  std::array<double, kColumns.size()> values{};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::optional<double> value =
        places.pose[i] < cells.size() ? number(cells[places.pose[i]]) : std::nullopt;
    if (!value) return Error{std::string(kColumns[i]) + " is not a number."};
    values[i] = *value;
  }
  Quat q(values[4], values[5], values[6], values[7]);
  const double norm = q.norm();
  if (std::abs(norm - 1) > 1e-3) return Error{"handle/q is not a unit quaternion."};
  if (std::abs(norm - 1) > 1e-9)  // a unit one as written by a run stays as it is, bit for bit
    q.normalize();
  TimedSample timed;
  timed.time = values[0];
  timed.sample.X_DH = {q, Vec3(values[1], values[2], values[3])};
  for (std::size_t i = 0; i < kDriftColumns.size(); ++i) {
    if (!places.drift[i]) continue;
    const std::optional<double> drifted =
        *places.drift[i] < cells.size() ? number(cells[*places.drift[i]]) : std::nullopt;
    if (!drifted) return Error{std::string(kDriftColumns[i]) + " is not a number."};
    timed.sample.X_DH.p[static_cast<Eigen::Index>(i)] -= *drifted;
  }
  timed.sample.strip_ohm = strip_of(cells, places.strip);
  return timed;
}

// s; the rows may have gaps, but their times are on one grid.
double tick_of(const std::vector<TimedSample>& rows) {
  double shortest = rows[1].time - rows[0].time;
  for (std::size_t i = 2; i < rows.size(); ++i)
    shortest = std::min(shortest, rows[i].time - rows[i - 1].time);
  const double duration = rows.back().time - rows.front().time;
  const double tick_s = duration / std::round(duration / shortest);
  const std::optional<double> rate = whole_rate(tick_s);
  return rate ? 1 / *rate : tick_s;
}

Result<std::vector<TimedSample>> rows_of_trace(const std::filesystem::path& path, TraceReader& trace) {
  Places places;
  for (std::size_t i = 0; i < kColumns.size(); ++i) {
    const std::optional<std::size_t> column = trace.column(kColumns[i]);
    if (!column) {
      return Error{path.string() + " is neither a tape nor a trace: it has no column " + kColumns[i] +
                   ". Name a tape, or a trace.csv with timestamp, handle/p and handle/q."};
    }
    places.pose[i] = *column;
  }
  for (std::size_t i = 0; i < kDriftColumns.size(); ++i) places.drift[i] = trace.column(kDriftColumns[i]);
  for (const char* name : kStripColumns)
    if (!places.strip) places.strip = trace.column(name);
  std::vector<TimedSample> rows;
  while (trace.next()) {
    const std::string place = path.string() + ", line " + std::to_string(trace.line()) + ": ";
    const Result<TimedSample> row = sample_of_row(trace.cells(), places);
    if (!row) return Error{place + row.error().sentence + " Correct or remove that line."};
    if (!rows.empty() && row->time <= rows.back().time)
      return Error{place + "the timestamp is not after the one before. Correct or remove that line."};
    rows.push_back(*row);
  }
  if (const std::optional<Error> fault = trace.fault()) return *fault;
  if (rows.size() < 2)
    return Error{path.string() + ": a motion needs two ticks at least. Record a longer run."};
  return rows;
}

Result<HandleMotion> motion_of_trace(const std::filesystem::path& path) {
  Result<TraceReader> trace = TraceReader::open(path);
  if (!trace) return trace.error();
  const Result<std::vector<TimedSample>> rows = rows_of_trace(path, *trace);
  if (!rows) return rows.error();
  HandleMotion motion;
  motion.space = HandleMotion::Space::scene;
  motion.tick_s = tick_of(*rows);
  motion.complete = trace->complete();
  for (const TimedSample& row : *rows) {
    const double tick = std::round((row.time - rows->front().time) / motion.tick_s);
    if (!(tick < static_cast<double>(std::ssize(*rows) + kMaxLost))) return too_many_lost(path);
    while (static_cast<double>(motion.samples.size()) < tick)
      motion.samples.push_back(DeviceSample(motion.samples.back()));
    motion.samples.push_back(row.sample);
  }
  return motion;
}

}  // namespace

Result<HandleMotion> read_motion(const std::filesystem::path& path) {
  const Result<RegularFile> file = RegularFile::open(path);
  if (!file) return read_error(path, file.error());
  const Result<std::string> start = file->first_bytes(kTapeMagic.size());
  return start && *start == kTapeMagic ? motion_of_tape(path) : motion_of_trace(path);
}

}  // namespace fulcrum::record
