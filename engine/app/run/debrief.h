#pragma once
// What came of a trial, for the screen.

#include "engine/app/run/run_sink.h"
#include "engine/ui/overlay_state.h"

namespace fulcrum::app {

// Of a trial that has ended: its score, then when each checkpoint counted. expert: what it is compared with;
// null: nothing.
ui::Debrief debrief(const Prepared& prepared, const RunSink& sink, const session::TrialMetrics* expert,
                    bool has_start_page);

}  // namespace fulcrum::app
