#include "engine/app/window/review.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

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
      return ui::Timeline::Mark::Kind::fair;
    case EventKind::hard_touch:
    case EventKind::fault:
      return ui::Timeline::Mark::Kind::bad;
  }
  return ui::Timeline::Mark::Kind::fair;
}

std::string words_for(const session::TrialEvent& event) {
  std::string words(name_of(event.kind));
  if (!event.text.empty()) words.append(": ").append(event.text);
  return words;
}

}  // namespace

void Review::go_to(double time, const RunSink& sink) {
  at_ = std::clamp(time, 0.0, sink.time());
}

void Review::press(Key key, const RunSink& sink, bool far) {
  const std::vector<session::TrialEvent>& events = sink.meter().events();
  // From the card, the trial's end is where one comes from.
  const double at = at_.value_or(sink.time());
  switch (key) {
    case Key::back:
      return go_to(at - (far ? kFar : kNear), sink);
    case Key::on:
      return go_to(at + (far ? kFar : kNear), sink);
    case Key::before: {
      const auto event = std::find_if(events.rbegin(), events.rend(),
                                      [&](const session::TrialEvent& one) { return one.time < at - 1e-6; });
      return go_to(event == events.rend() ? 0 : event->time, sink);
    }
    case Key::after: {
      const auto event =
          std::ranges::find_if(events, [&](const session::TrialEvent& one) { return one.time > at + 1e-6; });
      return go_to(event == events.end() ? sink.time() : event->time, sink);
    }
    case Key::card:
      at_ = at_ ? std::nullopt : std::optional(sink.time());
  }
}

scenario::TaskState Review::task(const RunSink& sink) const {
  scenario::TaskState state = sink.task();
  state.step = 0;
  for (std::optional<double>& reached : state.reached) {
    if (reached && *reached > *at_ + 1e-9) reached.reset();
    if (reached) ++state.step;
  }
  state.completed = state.step == state.reached.size();
  state.inside = false;
  state.dwell_progress = 0;
  state.time = *at_;
  state.hard_touches = std::ranges::count_if(sink.meter().events(), [&](const session::TrialEvent& event) {
    return event.kind == EventKind::hard_touch && event.time <= *at_ + 1e-9;
  });
  return state;
}

ui::Timeline Review::timeline(const RunSink& sink) const {
  ui::Timeline timeline{.end_s = sink.time(), .at_s = at_, .marks = {}, .caption = {}};
  const session::TrialEvent* nearest = nullptr;
  for (const session::TrialEvent& event : sink.meter().events()) {
    timeline.marks.push_back({event.time, mark_of(event.kind)});
    if (!at_ || std::abs(event.time - *at_) > kAtAnEvent) continue;
    if (nearest == nullptr || std::abs(event.time - *at_) < std::abs(nearest->time - *at_)) nearest = &event;
  }
  if (!at_) {
    timeline.caption = "Arrow keys look back";
    return timeline;
  }
  char text[32];
  std::snprintf(text, sizeof text, "%.1f s", *at_);
  timeline.caption = text;
  if (nearest != nullptr) timeline.caption += ", " + words_for(*nearest);
  return timeline;
}

}  // namespace fulcrum::app
