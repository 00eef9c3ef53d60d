#pragma once
// report.html of a trial: one file that needs nothing else.

#include <optional>
#include <string>

#include "engine/report/page.h"
#include "engine/session/score.h"
#include "engine/session/trial.h"

namespace fulcrum::session {

// How old the tool is by the time it is seen.
struct PictureAge {
  report::Table stages;
  report::Plot frames;
};

struct TrialPage {
  const Trial& trial;
  std::string about;        // the task, in a sentence
  std::string participant;  // empty: nobody was named
  const Score& score;
  const TrialCurves& curves;
  std::optional<double> hard_touch{};           // N, the task's limit
  std::optional<double> expert_time{};          // s
  std::vector<std::string> faults{}, limits{};  // sentences, of what befell it
  std::string replay_command{};
  std::string heard{};              // how many blows, and how late; empty: nobody listened
  std::optional<PictureAge> age{};  // where somebody saw pictures
};

std::string trial_html(const TrialPage& page);

}  // namespace fulcrum::session
