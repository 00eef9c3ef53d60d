#include "engine/app/window/review.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include "engine/app/picture/bridge.h"
#include "haptics/safety/faults.h"

namespace fulcrum::app {
namespace {

using EventKind = session::TrialEvent::Kind;

constexpr double kNear = 0.1, kFar = 1.0;  // s
constexpr double kAtAnEvent = 0.06;        // s, about it

ui::Timeline::Mark::Kind mark_of(EventKind kind) {
  switch (kind) {
    case EventKind::checkpoint:
      return ui::Timeline::Mark::Kind::good;
    case EventKind::touch_on_the_way:
    case EventKind::slip:
    case EventKind::pause:
      return ui::Timeline::Mark::Kind::fair;
    case EventKind::hard_touch:
    case EventKind::trespass:
    case EventKind::fault:
      return ui::Timeline::Mark::Kind::bad;
  }
  return ui::Timeline::Mark::Kind::fair;
}

std::string words_for(const session::TrialEvent& event) {
  std::string words(name_of(event.kind));
  if (!event.text.empty()) words.append(": ").append(event.text);
  if (words.ends_with('.')) words.pop_back();  // a part of a caption
  return words;
}

std::string seconds(double time) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f s", time);
  return text;
}

// scale: of the unit that is shown, for one of the curve's.
ui::Timeline::Plot plot(const char* name, const char* unit, const session::Envelope& curve,
                        std::optional<double> limit, double scale = 1) {
  ui::Timeline::Plot made{name, unit, curve.largest(), curve.interval(), limit};
  for (double& value : made.largest) value *= scale;
  return made;
}

}  // namespace

PlotLimits plot_limits(const SceneDesc& scene, const scenario::TaskDesc& task) {
  PlotLimits limits{force_limit_W(scene), scene.coupling.max_torque};
  if (task.hard_touch) limits.force_N = task.hard_touch;
  return limits;
}

Review::Review(double tick_s)
    : film_(tick_s),
      limits_{{kForceClamped, "the device's greatest force"},
              {kTorqueClamped, "the device's greatest torque"},
              {kMotorClamped, "a motor at its limit"}} {}

void Review::add(const TickRecord& record, double time) {
  film_.add(record, time);
  for (AtLimit& limit : limits_) {
    if ((record.faults & limit.fault) == 0) continue;
    const bool begins = !limit.last || time - *limit.last > session::TrialMeter::kTouchPause;
    limit.last = time;
    if (begins && at_limit_.size() < session::TrialMeter::kMostEvents)
      at_limit_.push_back({time, limit.words, ui::Timeline::Mark::Kind::bad});
  }
}

std::vector<Review::Event> Review::events(const RunSink& sink) const {
  std::vector<Event> all = at_limit_;
  for (const session::TrialEvent& event : sink.meter().events())
    all.push_back({event.time, words_for(event), mark_of(event.kind)});
  std::ranges::stable_sort(all, {}, &Event::time);
  return all;
}

void Review::go_to(double time, const RunSink& sink) {
  at_ = std::clamp(time, 0.0, sink.time());
}

void Review::press(Key key, const RunSink& sink, bool far) {
  // From the card, the trial's end is where one comes from.
  const double at = at_.value_or(sink.time());
  switch (key) {
    case Key::back:
      return go_to(at - (far ? kFar : kNear), sink);
    case Key::on:
      return go_to(at + (far ? kFar : kNear), sink);
    case Key::before: {
      const std::vector<Event> all = events(sink);
      const auto event =
          std::find_if(all.rbegin(), all.rend(), [&](const Event& one) { return one.time < at - 1e-6; });
      return go_to(event == all.rend() ? 0 : event->time, sink);
    }
    case Key::after: {
      const std::vector<Event> all = events(sink);
      const auto event = std::ranges::find_if(all, [&](const Event& one) { return one.time > at + 1e-6; });
      return go_to(event == all.end() ? sink.time() : event->time, sink);
    }
    case Key::card:
      at_ = at_ ? std::nullopt : std::optional(sink.time());
  }
}

double Review::same_part_s(const RunSink& sink, const ExpertRun& expert) const {
  return same_part(expert, sink.task().reached, *at_);
}

scenario::TaskState Review::task(const RunSink& sink, const scenario::TaskDesc& task) const {
  const auto is_past = [&](double time) { return time <= *at_ + 1e-9; };
  std::vector<std::optional<double>> reached = sink.task().reached;
  for (std::optional<double>& time : reached)
    if (time && !is_past(*time)) time.reset();
  scenario::TaskState state = state_after(task, std::move(reached));
  state.time = *at_;
  const auto count = [&](EventKind kind) {
    return std::ranges::count_if(sink.meter().events(), [&](const session::TrialEvent& event) {
      return event.kind == kind && is_past(event.time);
    });
  };
  state.hard_touches = count(EventKind::hard_touch);
  state.slips = count(EventKind::slip);
  state.trespasses = count(EventKind::trespass);
  return state;
}

ui::Timeline Review::timeline(const RunSink& sink, const PlotLimits& limits, const ExpertRun* expert) const {
  ui::Timeline timeline{.end_s = sink.time(), .at_s = at_, .marks = {}, .caption = {}};
  const std::vector<Event> all = events(sink);
  const Event* nearest = nullptr;
  for (const Event& event : all) {
    timeline.marks.push_back({event.time, event.kind});
    if (!at_ || std::abs(event.time - *at_) > kAtAnEvent) continue;
    if (nearest == nullptr || std::abs(event.time - *at_) < std::abs(nearest->time - *at_)) nearest = &event;
  }
  if (!at_) {
    timeline.caption = "Arrow keys look back";
    return timeline;
  }
  timeline.caption = seconds(*at_);
  if (nearest != nullptr) timeline.caption += ", " + nearest->words;
  if (expert != nullptr)
    timeline.caption += "; in lines the expert at " + seconds(same_part_s(sink, *expert)) + " (F5)";
  const session::TrialCurves& curves = sink.meter().curves();
  timeline.plots = {plot("Force", "N", curves.force, limits.force_N),
                    plot("Torque", "N\u00B7m", curves.torque, limits.torque_Nm),
                    plot("Depth", "mm", curves.depth, std::nullopt, 1e3),
                    plot("Speed", "mm/s", curves.speed, std::nullopt, 1e3)};
  return timeline;
}

}  // namespace fulcrum::app
