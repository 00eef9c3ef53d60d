#pragma once
// What is kept of the expert's run: its figures, and its tool's way to show beside a trainee's.

#include <optional>
#include <vector>

#include "engine/app/run/film.h"
#include "engine/session/trial_metrics.h"
#include "haptics/math/pose.h"

namespace fulcrum::app {

using ToolFilm = FilmOf<Pose, 1500>;

struct ExpertRun {
  session::TrialMetrics metrics;
  std::vector<std::optional<double>> reached;  // (checkpoints) s of the run at which each one counted
  std::vector<ToolFilm::Frame> way;            // X_WT, (1 to ToolFilm::kMost), times ascending
};

// s: the moment of the expert's run at which it was at the same part of the task as the trainee at `time` s
// of a trial. Between two checkpoints that both reached: where the same share of the time between them is
// over. Where one of the two went in another order than the list: at the same time. On the way to one that
// the trainee never reached the expert goes at its own pace, and waits there. reached: as the trial ended.
double same_part(const ExpertRun& expert, const std::vector<std::optional<double>>& reached, double time);

// Where the expert's tool was at that time, between the poses that are kept. The way is not empty.
Pose tool_at(const ExpertRun& expert, double time);

}  // namespace fulcrum::app
