#pragma once
// Where every tick of a run ends up, whatever loop it comes from: judged, recorded, added up.

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "engine/app/picture/afterglow.h"
#include "engine/app/prepare/prepare.h"
#include "engine/app/run/penetration.h"
#include "engine/app/run/program_faults.h"
#include "engine/app/run/sound_file.h"
#include "engine/app/run/still_handle.h"
#include "engine/record/recorder.h"
#include "engine/record/run_totals.h"
#include "engine/record/summary.h"
#include "engine/scenario/task_judge.h"
#include "engine/session/trial_meter.h"
#include "haptics/loop/tick_event.h"

namespace fulcrum::app {

class RunSink {
public:
  // recorder: none, and nothing is written. limit_s: the trial ends there. faults: what befalls the program
  // on the way; null: nothing.
  RunSink(const Prepared& prepared, std::optional<record::Recorder> recorder, double limit_s,
          ProgramFaults* faults = nullptr);

  // From the first tick on: says so where the handle never moves.
  void watch_handle() { still_handle_.emplace(tick_s_); }

  // From the first tick on: what would be heard of them.
  void write_sound(std::unique_ptr<SoundFile> file) { sound_ = std::move(file); }
  bool writes_sound() const { return sound_ != nullptr; }

  void take(const TickEvent& event);
  void flush_if_due();  // live: every few milliseconds

  enum class End { running, completed, limit };
  End end() const;
  bool handle_is_still() const { return still_handle_ && still_handle_->is_still(); }
  bool recording_failed() const { return recorder_failed_; }
  // The force is stopped in the newest tick, and not, or not only, since somebody asked for it.
  bool stopped_by_fault() const { return stopped_by_fault_; }

  const record::RunTotals& totals() const { return totals_; }  // so far
  const scenario::TaskState& task() const { return judge_.state(); }
  std::optional<std::int64_t> hard_touches() const;  // so far; none: the task does not count them
  const session::TrialMeter& meter() const { return meter_; }
  bool guided() const { return meter_.guided(); }  // so far
  session::TrialMetrics metrics() const { return meter_.metrics(judge_.state()); }
  const TickRecord& last() const { return last_; }  // before the first: where all begins
  const Afterglow& afterglow() const { return afterglow_; }
  // s, of the trial: it rests while the force is stopped.
  double time() const { return static_cast<double>(ticks_ - stopped_ticks_) * tick_s_; }
  double limit() const { return limit_s_; }

  // Closes the files and measures the penetration. device, hand, built and left_out are the caller's to add.
  struct Outcome {
    record::Summary summary;
    double time_s = 0;     // of the trial
    bool recorded = true;  // false: the recording stopped early, and a sentence said so
  };
  Outcome finish();

private:
  void report_recorder();

  const Prepared& prepared_;
  double tick_s_;
  double limit_s_;
  ProgramFaults* faults_;
  std::optional<StillHandle> still_handle_;
  std::unique_ptr<SoundFile> sound_;  // null: none is written
  std::int64_t ticks_ = 0, stopped_ticks_ = 0;
  std::optional<record::Recorder> recorder_;
  bool recorder_failed_ = false;
  scenario::TaskJudge judge_;
  session::TrialMeter meter_;
  record::RunTotals totals_;
  PenetrationMeter penetration_;
  std::vector<std::int64_t> cpu_ns_;
  std::int64_t late_ticks_ = 0, lost_ticks_ = 0;
  TickRecord last_;
  bool stopped_by_fault_ = false;
  Afterglow afterglow_;
  bool has_brief_knobs_;
};

}  // namespace fulcrum::app
