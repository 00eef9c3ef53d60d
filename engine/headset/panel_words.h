#pragma once
// What is said to who wears a headset: the panels of a window, in words for hands.

#include <optional>
#include <string>

#include "engine/app/prepare/prepare.h"
#include "engine/app/run/debrief.h"
#include "engine/app/run/run_session.h"
#include "engine/app/settings/settings.h"
#include "engine/headset/colocated.h"
#include "engine/ui/overlay_state.h"

namespace fulcrum::headset {

// One picture's.
struct PanelMoment {
  const TickRecord& record;
  const Colocated* colocated;              // null: nobody asked
  const std::string& stopped_by;           // what a pause came of; empty: somebody asked for it
  bool is_hand_in_sight;                   // or a controller
  const std::optional<ui::Debrief>& card;  // none: the trial has not ended
};

ui::OverlayState panel_words(const app::Prepared& prepared, const app::RunOptions& options,
                             const app::Settings& settings, app::RunSession& attempt,
                             const PanelMoment& moment);

// What came of a trial that has ended, on a card that a squeeze puts away.
ui::Debrief headset_card(const app::Prepared& prepared, const app::RunOptions& options,
                         const app::RunSink& sink, const app::Comparison& with);

}  // namespace fulcrum::headset
