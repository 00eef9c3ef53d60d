#pragma once
// What came of a trial, for the screen.

#include "engine/app/run/run_sink.h"
#include "engine/ui/overlay_state.h"

namespace fulcrum::app {

// Of a trial that has ended: its score, then when each checkpoint counted. expert: what it is compared with;
// null: nothing. has_pad: its foot names a gamepad's buttons, too.
ui::Debrief debrief(const Prepared& prepared, const RunSink& sink, const session::TrialMetrics* expert,
                    bool has_start_page, bool has_pad = false);

}  // namespace fulcrum::app
