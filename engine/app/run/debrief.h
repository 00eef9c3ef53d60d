#pragma once
// What came of a trial, for the screen.

#include "engine/app/run/run_sink.h"
#include "engine/app/run/trial_results.h"
#include "engine/ui/overlay_state.h"

namespace fulcrum::app {

// What a trial is compared with.
struct Comparison {
  const session::TrialMetrics* expert = nullptr;  // null: nobody
  std::optional<EarlierTrials> earlier{};         // none: there were none
};

// Of a trial that has ended: its score, then when each checkpoint counted. has_pad: its foot names a
// gamepad's buttons, too.
ui::Debrief debrief(const Prepared& prepared, const RunSink& sink, const Comparison& with,
                    bool has_start_page, bool has_pad = false);

}  // namespace fulcrum::app
