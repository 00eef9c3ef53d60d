#include "engine/app/run/run_sink.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "engine/app/cli/terminal.h"
#include "engine/app/run/nearest_part.h"
#include "haptics/safety/faults.h"

namespace fulcrum::app {

RunSink::RunSink(const Prepared& prepared, std::optional<record::Recorder> recorder, double limit_s,
                 ProgramFaults* faults)
    : prepared_(prepared),
      tick_s_(prepared.haptic.scene.tick_s),
      limit_s_(limit_s),
      faults_(faults),
      recorder_(std::move(recorder)),
      judge_(prepared.haptic.task, tick_s_),
      meter_(prepared.haptic.task, tick_s_),
      totals_(tick_s_),
      penetration_(tick_s_),
      afterglow_(prepared.haptic.scene.tool.X_HT.inverse().p),
      has_brief_knobs_(
          std::ranges::any_of(effect_knobs(prepared.haptic.scene, prepared.haptic.scene, {}), &Knob::brief)) {
  const ToolDesc& tool = prepared.haptic.scene.tool;
  last_.X_WT = tool.X_WT_start;
  last_.X_WH = tool.X_WT_start * tool.X_HT.inverse();
  cpu_ns_.reserve(static_cast<std::size_t>(std::ceil(limit_s / tick_s_)) + 1);
}

void RunSink::take(const TickEvent& event) {
  judge_.judge(event.record);
  meter_.note(event.record, judge_.state());
  totals_.add(event.record);
  penetration_.note(event.record);
  cpu_ns_.push_back(event.cpu_ns);
  if (static_cast<double>(event.wake_late_ns) * 1e-9 >= tick_s_) ++late_ticks_;
  lost_ticks_ += event.lost_before;
  if (recorder_) {
    recorder_->tick({.record = event.record,
                     .sample = event.sample,
                     .commands = event.commands(),
                     .lost_before = event.lost_before,
                     .task_step = static_cast<std::int32_t>(judge_.state().step),
                     .hard_touches = hard_touches(),
                     .cpu_ns = event.cpu_ns,
                     .wake_late_ns = event.wake_late_ns});
    report_recorder();
  }
  last_ = event.record;
  const SceneDesc& scene = prepared_.haptic.scene;
  const double time = static_cast<double>(ticks_) * tick_s_;
  afterglow_.add(event.record, time,
                 has_brief_knobs_ ? effect_knobs(scene, scene, event.record) : std::vector<Knob>());
  ++ticks_;
  if (still_handle_ && still_handle_->note(event.sample)) complain(StillHandle::kSentence);
  if (faults_ != nullptr) faults_->pass(static_cast<double>(ticks_) * tick_s_);
  if (sound_) sound_->take(event.record, judge_.state());
  if (event.record.stopped) ++stopped_ticks_;
  const std::uint32_t why = event.record.faults & kStoppingFaults & ~kStopRequested;
  stopped_by_fault_ = event.record.stopped && (stopped_by_fault_ || why != 0);
}

std::optional<std::int64_t> RunSink::hard_touches() const {
  if (!prepared_.haptic.task.hard_touch) return std::nullopt;
  return judge_.state().hard_touches;
}

void RunSink::flush_if_due() {
  if (!recorder_) return;
  recorder_->flush_if_due(record::Recorder::Clock::now());
  report_recorder();
}

void RunSink::report_recorder() {
  if (const std::optional<Error> error = recorder_->take_error()) {
    complain(error->sentence);
    recorder_failed_ = true;
  }
}

RunSink::End RunSink::end() const {
  if (judge_.state().completed) return End::completed;
  // Counted in ticks: a sum of times would end a tick early or late.
  return ticks_ - stopped_ticks_ >= std::llround(limit_s_ / tick_s_) ? End::limit : End::running;
}

RunSink::Outcome RunSink::finish() {
  Outcome outcome;
  record::Summary& summary = outcome.summary;
  summary.scenario = prepared_.name;
  summary.seed = prepared_.scenario.seed;
  summary.tick_s = tick_s_;
  outcome.time_s = time();
  summary.take(totals_);
  const scenario::TaskState& task = judge_.state();
  summary.completed = task.completed;
  summary.guided = guided();
  const scenario::TaskDesc& desc = prepared_.haptic.task;
  if (desc.hard_touch) summary.hard_touches = {task.hard_touches, task.hard_touch_time};
  if (has_ways(desc)) summary.slips = task.slips;
  if (!desc.avoid.empty()) summary.trespasses = {task.trespasses, task.trespass_time};
  summary.completion_time_s = judge_.completion_time();
  for (std::size_t i = 0; i < desc.checkpoints.size(); ++i)
    summary.checkpoints.push_back({desc.checkpoints[i].name, task.reached[i]});
  const Penetration deepest = penetration_.deepest(prepared_.haptic.scene_W, prepared_.haptic.tool_T,
                                                   prepared_.haptic.scene.scene_field.get());
  summary.max_penetration_m = deepest.depth;
  summary.max_penetration_within_m = deepest.within;
  if (deepest.depth > 0) {
    summary.max_penetration_at_s = deepest.at;
    summary.max_penetration_part = nearest_part(prepared_.scenario, prepared_.models, deepest.p_W);
  }
  if (!cpu_ns_.empty()) summary.tick_cpu_us = record::tick_cpu_percentiles(cpu_ns_);
  summary.late_ticks = late_ticks_;
  summary.lost_ticks = lost_ticks_;
  if (recorder_) {
    const record::Recorder::Outcome recorded = recorder_->finish();
    report_recorder();
    summary.trace_sha256 = recorded.trace_sha256;
    outcome.recorded = recorded.complete && !recorder_failed_;
  }
  if (const std::optional<Error> error = sound_ ? sound_->close() : std::nullopt) {
    complain(error->sentence);
    outcome.recorded = false;
  }
  return outcome;
}

}  // namespace fulcrum::app
