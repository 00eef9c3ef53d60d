#include "engine/session/trial_meter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/session/smoothness.h"
#include "haptics/safety/faults.h"

namespace fulcrum::session {
namespace {

constexpr double kSpeedInterval = 0.01;         // s, of speeds to begin with: hands move below 10 Hz
constexpr double kLongestInterval = 0.04;       // s, still enough for 10 Hz
constexpr std::size_t kMostSpeeds = 1 << 17;    // 22 minutes of them, 87 at the longest interval
constexpr double kForceStep = 0.01;             // N, of the 95th percentile
constexpr std::size_t kForceSteps = 100 * 100;  // up to 100 N; what is more counts as that
constexpr double kPercentile = 0.95;

double magnitude(const Vec3& vector) {
  const double norm = vector.norm();
  return std::isfinite(norm) ? norm : 0;
}

}  // namespace

std::string_view name_of(TrialEvent::Kind kind) {
  switch (kind) {
    case TrialEvent::Kind::checkpoint:
      return "checkpoint";
    case TrialEvent::Kind::hard_touch:
      return "hard touch";
    case TrialEvent::Kind::touch_on_the_way:
      return "touch on the way";
    case TrialEvent::Kind::slip:
      return "slip";
    case TrialEvent::Kind::trespass:
      return "trespass";
    case TrialEvent::Kind::pause:
      return "pause";
    case TrialEvent::Kind::fault:
      return "fault";
  }
  return "";
}

TrialMeter::TrialMeter(const scenario::TaskDesc& task, double tick_s)
    : task_(task),
      tick_s_(tick_s),
      ticks_each_(std::max<std::int64_t>(1, std::llround(kSpeedInterval / tick_s))),
      force_ticks_(kForceSteps, 0),
      ticks_untouched_(std::llround(kTouchPause / tick_s)),
      reached_(task.checkpoints.size(), false),
      curves_{Envelope(tick_s), Envelope(tick_s), Envelope(tick_s), Envelope(tick_s)} {}

void TrialMeter::note_event(TrialEvent::Kind kind, std::string text) {
  if (events_.size() < kMostEvents)
    events_.push_back({static_cast<double>(ticks_) * tick_s_, kind, std::move(text)});
}

void TrialMeter::note(const TickRecord& record, const scenario::TaskState& task) {
  if (fulcrum::guided(record)) guided_ = true;
  const std::uint32_t began = record.faults & kStoppingFaults & ~faults_;
  faults_ = record.faults & kStoppingFaults;
  for (const FaultName& fault : fault_names())
    if ((fault.bit & began) != 0) {
      const bool asked_for = fault.bit == kStopRequested;
      note_event(asked_for ? TrialEvent::Kind::pause : TrialEvent::Kind::fault,
                 asked_for ? "" : fault.sentence);
    }
  if (record.stopped) {
    p_WC_.reset();  // where the tool is after the pause is no way that it went
    return;
  }
  note_motion(record);
  note_touch(record, task);
  for (std::size_t i = 0; i < task_.checkpoints.size(); ++i) {
    if (!task.reached[i] || reached_[i]) continue;
    reached_[i] = true;
    note_event(TrialEvent::Kind::checkpoint, task_.checkpoints[i].name);
  }
  if (task.slips > slips_) note_event(TrialEvent::Kind::slip, {});
  if (task.trespasses > trespasses_) note_event(TrialEvent::Kind::trespass, {});
  slips_ = task.slips;
  trespasses_ = task.trespasses;
  ++ticks_;
}

void TrialMeter::note_motion(const TickRecord& record) {
  const Vec3 p_WC = record.X_WT * task_.touch_point;
  const double way = p_WC_ ? magnitude(p_WC - *p_WC_) : 0;
  if (p_WC.allFinite()) p_WC_ = p_WC;
  path_ += way;
  curves_.speed.add(way / tick_s_);
  note_speed(way / tick_s_);
}

void TrialMeter::note_speed(double speed) {
  if (too_long_) return;
  speed_sum_ += speed;
  if (++speed_ticks_ < ticks_each_) return;
  speeds_.push_back(speed_sum_ / static_cast<double>(ticks_each_));
  speed_sum_ = 0;
  speed_ticks_ = 0;
  if (speeds_.size() < kMostSpeeds) return;
  for (std::size_t i = 0; i < kMostSpeeds / 2; ++i) speeds_[i] = 0.5 * (speeds_[2 * i] + speeds_[2 * i + 1]);
  speeds_.resize(kMostSpeeds / 2);
  ticks_each_ *= 2;
  too_long_ = static_cast<double>(ticks_each_) * tick_s_ > 1.01 * kLongestInterval;
}

void TrialMeter::note_touch(const TickRecord& record, const scenario::TaskState& task) {
  const double force = magnitude(record.contact_F_T_W.force);
  curves_.force.add(force);
  curves_.torque.add(magnitude(record.contact_F_T_W.torque));
  curves_.depth.add(record.depth_max);
  if (record.depth_max > depth_peak_) depth_peak_ = record.depth_max;
  torque_error_ += magnitude(record.coupling_F_T_W.torque) * tick_s_;
  if (task.hard_touches > hard_touches_) note_event(TrialEvent::Kind::hard_touch, {});
  hard_touches_ = task.hard_touches;
  if (!(force > 0)) {
    ++ticks_untouched_;
    return;
  }
  const bool begins = static_cast<double>(ticks_untouched_) * tick_s_ >= kTouchPause;
  ticks_untouched_ = 0;
  const auto noted = static_cast<std::size_t>(std::ranges::count(reached_, true));
  const bool reaches = reached_count(task) > noted;
  if (begins && !task.completed && !task.inside && !reaches) {
    ++on_the_way_;
    note_event(TrialEvent::Kind::touch_on_the_way, {});
  }
  ++contact_ticks_;
  force_sum_ += force;
  force_peak_ = std::max(force_peak_, force);
  ++force_ticks_[static_cast<std::size_t>(
      std::min(static_cast<double>(kForceSteps - 1), force / kForceStep))];
}

// Nearest rank, to the end of its step.
double TrialMeter::force_95() const {
  const double rank = kPercentile * static_cast<double>(contact_ticks_);
  double below = 0;
  for (std::size_t i = 0; i < kForceSteps; ++i) {
    below += static_cast<double>(force_ticks_[i]);
    if (below > 0 && below >= rank)
      return i + 1 == kForceSteps ? force_peak_
                                  : std::min(force_peak_, kForceStep * static_cast<double>(i + 1));
  }
  return 0;
}

TrialMetrics TrialMeter::metrics(const scenario::TaskState& task) const {
  TrialMetrics metrics;
  metrics.time = static_cast<double>(ticks_) * tick_s_;
  metrics.completed = task.completed;
  metrics.guided = guided_;
  for (std::size_t i = 0; i < task_.checkpoints.size(); ++i) {
    const bool optional = task_.checkpoints[i].optional;
    ++(optional ? metrics.optional_checkpoints : metrics.checkpoints);
    if (task.reached[i]) ++(optional ? metrics.optional_reached : metrics.checkpoints_reached);
  }
  metrics.path = path_;
  if (!too_long_)
    metrics.smoothness = spectral_arc_length(speeds_, static_cast<double>(ticks_each_) * tick_s_);
  metrics.contact_time = static_cast<double>(contact_ticks_) * tick_s_;
  if (contact_ticks_ > 0) metrics.force_mean = force_sum_ / static_cast<double>(contact_ticks_);
  metrics.force_95 = force_95();
  metrics.force_peak = force_peak_;
  metrics.depth_peak = depth_peak_;
  metrics.touches_on_the_way = on_the_way_;
  if (task_.hard_touch) metrics.hard_touches = task.hard_touches;
  metrics.hard_touch_time = task.hard_touch_time;
  if (has_ways(task_)) metrics.slips = task.slips;
  if (!task_.avoid.empty()) metrics.trespasses = task.trespasses;
  metrics.trespass_time = task.trespass_time;
  metrics.torque_error = torque_error_;
  metrics.force_error = force_sum_ * tick_s_;
  return metrics;
}

}  // namespace fulcrum::session
