#include "engine/record/recorder.h"

#include <algorithm>
#include <utility>

#include "engine/files/block_file.h"
#include "engine/record/digest.h"
#include "engine/record/flight_log.h"
#include "engine/record/run_folder.h"
#include "engine/record/tape_writer.h"
#include "engine/record/timing_writer.h"
#include "engine/record/trace_writer.h"

namespace fulcrum::record {

namespace {

constexpr double kFlushSimulated_s = 0.25;
constexpr std::chrono::milliseconds kFlushReal{500};
// A block that does not fit on the disk is dropped whole: small ones lose little.
constexpr std::size_t kFlushBytes = 64 * 1024;

std::optional<Error> write_trace_json(const std::filesystem::path& path, const TraceColumns& columns) {
  Result<BlockFile> file = BlockFile::create(path);
  if (!file) return file.error();
  if (std::optional<Error> error = file->append(columns.json())) return error;
  return file->close();
}

}  // namespace

struct Recorder::State {
  std::filesystem::path folder;
  TraceColumns columns;
  TraceWriter trace;
  TimingWriter timing;
  TapeWriter tape;
  std::optional<ChannelFiles> channels;
  std::int64_t ticks_per_flush;
  FlightLog flight{};
  bool flight_written = false;
  std::int64_t rows = 0;     // in the files
  std::int64_t pending = 0;  // not yet
  std::optional<Clock::time_point> last_flush{};
  bool recording = true;
  std::optional<Error> error{};  // until it is taken

  void flush();
  void write_flight();
  void stop(Error why);
};

// All files or none: one that fails takes the others back to the ticks before.
void Recorder::State::flush() {
  const std::int64_t ticks = std::exchange(pending, 0);
  if (ticks == 0) return;
  if (std::optional<Error> failure = trace.flush()) return stop(*std::move(failure));
  if (std::optional<Error> failure = timing.flush()) {
    trace.take_back();
    return stop(*std::move(failure));
  }
  if (channels) {
    if (std::optional<Error> failure = channels->flush()) {
      trace.take_back();
      timing.take_back();
      return stop(*std::move(failure));
    }
  }
  if (std::optional<Error> failure = tape.flush()) {
    trace.take_back();
    timing.take_back();
    if (channels) channels->take_back();
    return stop(*std::move(failure));
  }
  rows += ticks;
}

void Recorder::State::write_flight() {
  flight_written = true;
  Result<TraceWriter> file = TraceWriter::create(folder / kFlightName, columns);
  if (!file) return stop(file.error());
  for (std::size_t i = 0; i < flight.ticks().size(); ++i) {
    const FlightEntry& entry = flight.ticks()[i];
    file->row({entry.record, entry.task_step, entry.hard_touches});
  }
  std::optional<Error> failure = file->flush();
  if (!failure) failure = file->close();
  if (failure) stop(*std::move(failure));
}

void Recorder::State::stop(Error why) {
  if (recording) {
    recording = false;
    error = Error{std::move(why.sentence) + " Recording has stopped after the first " + std::to_string(rows) +
                  " ticks of the run."};
  }
}

Result<Recorder> Recorder::begin(const std::filesystem::path& folder, const TapeHeader& header,
                                 TraceColumns columns, const std::optional<ChannelRecording>& channels) {
  Result<TapeWriter> tape = TapeWriter::create(folder / kTapeName, header);
  if (!tape) return tape.error();
  Result<TraceWriter> trace = TraceWriter::create(folder / kTraceName, columns);
  if (!trace) return trace.error();
  Result<TimingWriter> timing = TimingWriter::create(folder / kTimingName);
  if (!timing) return timing.error();
  std::optional<ChannelFiles> channel_files;
  if (channels) {
    Result<ChannelFiles> files = ChannelFiles::create(folder, *channels, columns.tick_s());
    if (!files) return files.error();
    channel_files = std::move(*files);
  }
  if (std::optional<Error> error = write_trace_json(folder / kTraceJsonName, columns))
    return *std::move(error);
  const auto ticks_per_flush = static_cast<std::int64_t>(kFlushSimulated_s / columns.tick_s());
  return Recorder(
      std::make_unique<State>(State{.folder = folder,
                                    .columns = std::move(columns),
                                    .trace = std::move(*trace),
                                    .timing = std::move(*timing),
                                    .tape = std::move(*tape),
                                    .channels = std::move(channel_files),
                                    .ticks_per_flush = std::max<std::int64_t>(ticks_per_flush, 1)}));
}

Recorder::Recorder(std::unique_ptr<State> state) : state_(std::move(state)) {}
Recorder::Recorder(Recorder&&) noexcept = default;
Recorder& Recorder::operator=(Recorder&&) noexcept = default;
Recorder::~Recorder() = default;

void Recorder::tick(const RecordedTick& tick) {
  State& s = *state_;
  s.flight.add({tick.record, tick.task_step, tick.hard_touches});
  if (!s.recording) return;
  s.trace.row({tick.record, tick.task_step, tick.hard_touches});
  if (const VibrotactileCommand* command = channel_command(tick.record); s.channels && command)
    s.channels->tick(*command);
  s.timing.row({tick.record.tick, tick.cpu_ns, tick.wake_late_ns, tick.lost_before});
  s.tape.entry(tick.sample, tick.commands, tick.lost_before, digest(tick.record));
  ++s.pending;
  if (s.pending >= s.ticks_per_flush || s.trace.pending_bytes() >= kFlushBytes) s.flush();
  if (s.flight.full() && !s.flight_written) s.write_flight();
}

void Recorder::flush_if_due(Clock::time_point now) {
  State& s = *state_;
  if (!s.last_flush || s.pending == 0) {
    s.last_flush = now;
  } else if (now - *s.last_flush >= kFlushReal) {
    s.flush();
    s.last_flush = now;
  }
}

std::optional<Error> Recorder::take_error() {
  return std::exchange(state_->error, std::nullopt);
}

Recorder::Outcome Recorder::finish() {
  State& s = *state_;
  s.flush();
  if (s.flight.fault_seen() && !s.flight_written) s.write_flight();
  if (s.recording) {
    if (std::optional<Error> failure = s.tape.finish()) s.stop(*std::move(failure));
  }
  const std::optional<Error> of_channels = s.channels ? s.channels->close() : std::nullopt;
  for (std::optional<Error> failure : {s.trace.close(), s.timing.close(), of_channels})
    if (failure) s.stop(*std::move(failure));
  return {s.rows, s.trace.sha256_hex(), s.recording};
}

}  // namespace fulcrum::record
