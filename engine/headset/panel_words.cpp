#include "engine/headset/panel_words.h"

#include "drivers/registry.h"
#include "engine/app/picture/bridge.h"
#include "engine/app/picture/target_view.h"
#include "haptics/safety/faults.h"

namespace fulcrum::headset {
namespace {

// What is known here of a stop; empty: no more than its fault says.
std::string why_stopped(const TickRecord& record, const std::string& stopped_by, bool moved_by_hands) {
  const std::uint32_t faults = record.faults & kStoppingFaults;
  if (is_pause(faults))
    return (faults & kUnanswered) != 0 ? "the headset's runtime did not answer in time" : stopped_by;
  return faults == kSampleStale && moved_by_hands ? "the hand that held the tool went out of sight"
                                                  : std::string();
}

}  // namespace

ui::OverlayState panel_words(const app::Prepared& prepared, const app::RunOptions& options,
                             const app::Settings& settings, app::RunSession& attempt,
                             const PanelMoment& moment) {
  const app::RunSink& sink = attempt.sink();
  const TickRecord& record = moment.record;
  ui::OverlayState state =
      app::overlay_state(prepared, attempt.world().desc(), record, sink.afterglow(), sink.task());
  state.look = settings.look;
  if (state.trial) state.trial->limit_s = sink.limit();
  if (moment.card) {
    state.debrief = moment.card;
    state.force = ui::Force::on;  // what was stopped then is no stop now
    state.stop_reason.clear();
    return state;
  }
  const DeviceWords words = device_words(options.device);
  const bool in_hands = attempt.device().controllers != nullptr;
  if (moment.colocated != nullptr && moment.colocated->is_asked()) {
    if (!is_pause(record.faults) && state.force == ui::Force::stopped)
      state.message = state.stop_reason + "\n";
    state.force = ui::Force::on;  // nothing is to be resumed yet: what to do is in the message
    state.message += moment.colocated->text();
  } else if (state.force == ui::Force::stopped) {
    if (const std::string why = why_stopped(record, moment.stopped_by, is_of_headset(options.device));
        !why.empty())
      state.stop_reason = why + ". The force is off, and time rests.";
    state.message.append("To go on: ").append(words.go_on);
    if (!in_hands) state.message += ", or squeeze a controller";
    state.message += ".";
  } else if (tracks_hands(options.device) && !moment.is_hand_in_sight) {
    state.message = "No hand is in sight: hold one before the headset, without a controller.";
  } else {
    state.message = app::advice(prepared.haptic.task, sink.task(), words);
  }
  return state;
}

ui::Debrief headset_card(const app::Prepared& prepared, const app::RunOptions& options,
                         const app::RunSink& sink, const app::Comparison& with) {
  ui::Debrief card = app::debrief(prepared, sink, with, false);
  card.foot = tracks_hands(options.device) ? "Pinch to end." : "Squeeze a controller to end.";
  return card;
}

}  // namespace fulcrum::headset
