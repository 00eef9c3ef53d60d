#pragma once
// Writes a run into its folder while it goes on: trace.csv, trace.json, timing.csv, tape, a WAV for each
// vibrotactile channel, and flight.csv if the force was stopped by a fault. It belongs to one thread, never
// the haptic one: it writes files.
//
// What was ticked reaches the files every 0.25 s of simulated time and, with flush_if_due(), every 0.5 s of
// real time: a run that is killed loses no more than that. All files tell of the same ticks. If one cannot be
// written (a full disk), all are cut back to where they agree, the error is said once and recording ends; the
// run may go on.

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "engine/record/channel_files.h"
#include "engine/record/tape.h"
#include "engine/record/trace_columns.h"
#include "haptics/device/device.h"
#include "haptics/math/result.h"
#include "haptics/tick/command.h"
#include "haptics/world/tick_record.h"

namespace fulcrum::record {

struct RecordedTick {
  const TickRecord& record;
  const DeviceSample& sample;                  // that the tick ran with
  std::span<const Command> commands;           // given in this tick
  std::int64_t lost_before = 0;                // ticks lost to an overrun before this one
  std::int32_t task_step = 0;                  // after this tick
  std::optional<std::int64_t> hard_touches{};  // after this tick; none: the task does not count them
  std::int64_t cpu_ns = 0;                     // processor time of the tick
  std::int64_t wake_late_ns = 0;               // how long after its due time it began; 0 offline
};

class Recorder {
public:
  using Clock = std::chrono::steady_clock;

  // folder: from run_folder.h. The files are created; one that is there already is an error.
  static Result<Recorder> begin(const std::filesystem::path& folder, const TapeHeader& header,
                                TraceColumns columns,
                                const std::optional<ChannelRecording>& channels = std::nullopt);
  Recorder(Recorder&&) noexcept;
  Recorder& operator=(Recorder&&) noexcept;
  ~Recorder();  // without finish() the tape stays without its end, as after a kill

  void tick(const RecordedTick& tick);
  // Live: call it often, every few milliseconds.
  void flush_if_due(Clock::time_point now);

  // The sentence for the person, the first time it is asked for after writing failed.
  std::optional<Error> take_error();

  struct Outcome {
    std::int64_t rows = 0;     // ticks that the files hold
    std::string trace_sha256;  // of trace.csv as it lies there
    bool complete = false;     // every tick was written
  };
  Outcome finish();

private:
  struct State;
  explicit Recorder(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace fulcrum::record
