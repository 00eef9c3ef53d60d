#pragma once
// What a trial is worth, criterion by criterion, each with its reason. docs/results.md has the rules for who
// is judged by them.

#include <optional>
#include <string>
#include <vector>

#include "engine/scenario/task.h"
#include "engine/session/trial_metrics.h"

namespace fulcrum::session {

struct Criterion {
  std::string name;                // "Time"
  std::string value;               // "41.2 s"
  std::optional<double> points{};  // none: it is told and not judged
  double of = 0;                   // the most there may be
  std::string reason;              // a sentence
};

struct Score {
  std::vector<Criterion> criteria;
  // 0 to 100: the points there are, over the most that there may be. None: there is no expert to compare
  // with, the person was guided, or the task gives no points.
  std::optional<double> total;
};

// expert: the same task, done by the scenario's own hand; null: what only a comparison could judge is told
// and not judged. Without points to be had by comparison there is a total without an expert, too.
Score score(const TrialMetrics& trial, const TrialMetrics* expert,
            const scenario::ScoreWeights& weights = {});

// "41.2 s", "312 mm", "1.35 N": three digits, and never less than its unit makes sense of.
std::string in_seconds(double time);
std::string in_millimetres(double length);
std::string in_newtons(double force);

}  // namespace fulcrum::session
