#pragma once
// Measures a trial by its ticks, one record after the other: pure, so that a replay gives the figures of the
// run. Memory is bounded, however long the trial.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/scenario/task.h"
#include "engine/scenario/task_judge.h"
#include "engine/session/envelope.h"
#include "engine/session/trial_metrics.h"
#include "haptics/world/tick_record.h"

namespace fulcrum::session {

struct TrialEvent {
  enum class Kind { checkpoint, hard_touch, touch_on_the_way, slip, trespass, pause, fault };
  double time = 0;  // s, of the trial
  Kind kind = Kind::checkpoint;
  std::string text;  // the checkpoint's name, or what is wrong; empty: the kind says all
};

std::string_view name_of(TrialEvent::Kind kind);

// Over the trial, for plots.
struct TrialCurves {
  Envelope force, torque;  // N, N m, of the scene on the tool
  Envelope depth;          // m
  Envelope speed;          // m/s, of the touch point
};

class TrialMeter {
public:
  TrialMeter(const scenario::TaskDesc& task, double tick_s);

  // task: as the record left it. A stop is a pause: nothing is measured until it is acknowledged, but whether
  // the person was led.
  void note(const TickRecord& record, const scenario::TaskState& task);

  TrialMetrics metrics(const scenario::TaskState& task) const;
  bool guided() const { return guided_; }
  const TrialCurves& curves() const { return curves_; }
  // At most kMostEvents of them.
  const std::vector<TrialEvent>& events() const { return events_; }

  static constexpr std::size_t kMostEvents = 1000;
  // A touch that begins so soon after another is the same one.
  static constexpr double kTouchPause = 0.05;  // s

private:
  void note_event(TrialEvent::Kind kind, std::string text);
  void note_touch(const TickRecord& record, const scenario::TaskState& task);
  void note_motion(const TickRecord& record);
  void note_speed(double speed);
  double force_95() const;

  scenario::TaskDesc task_;
  double tick_s_;
  std::int64_t ticks_ = 0;  // of the trial
  bool guided_ = false;

  std::optional<Vec3> p_WC_;  // (3) m, of the touch point, a tick ago
  double path_ = 0;
  std::vector<double> speeds_;  // (n) m/s, mean of so many ticks each
  std::int64_t ticks_each_, speed_ticks_ = 0;
  double speed_sum_ = 0;
  bool too_long_ = false;  // for a smoothness

  std::vector<std::int64_t> force_ticks_;  // [i]: with a force of i to i + 1 steps
  std::int64_t contact_ticks_ = 0, ticks_untouched_;
  double force_sum_ = 0, force_peak_ = 0, depth_peak_ = 0, torque_error_ = 0;
  std::int64_t on_the_way_ = 0, hard_touches_ = 0;
  std::vector<bool> reached_;  // (checkpoints) noted as an event
  std::int64_t slips_ = 0, trespasses_ = 0;
  std::uint32_t faults_ = 0;

  TrialCurves curves_;
  std::vector<TrialEvent> events_;
};

}  // namespace fulcrum::session
