#include "engine/session/score.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string_view>

namespace fulcrum::session {
namespace {

constexpr double kCheckpointPoints = 40, kPoints = 15;
// Of the expert's figure: up to the first there are all points, from the second on none, and evenly fewer
// between.
constexpr double kAllUpTo = 1.5, kNoneFrom = 4;
constexpr double kLeastForce = 0.1;  // N, below which two forces do not differ
constexpr double kLeastTouches = 1;
constexpr double kPointsAHardTouch = 3;

std::string digits(double value, int places) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", places, value);
  return text;
}

std::string digits(double value, int places, const char* unit) {
  return digits(value, places) + ' ' + unit;
}

std::string count_text(std::int64_t count) {
  return std::to_string(count);
}

double points_of(double ratio) {
  return kPoints * std::clamp((kNoneFrom - ratio) / (kNoneFrom - kAllUpTo), 0.0, 1.0);
}

// A figure that is better the smaller it is, beside the expert's.
Criterion beside_expert(const char* name, std::string value, double of_trial, std::optional<double> of_expert,
                        std::string expert_text, bool completed, const char* why_none) {
  Criterion criterion{name, std::move(value), {}, kPoints, {}};
  if (!of_expert) {
    criterion.reason = why_none;
    return criterion;
  }
  if (!completed) {
    criterion.points = 0;
    criterion.reason = "It counts once the task is completed; the expert: " + std::move(expert_text) + ".";
    return criterion;
  }
  const double ratio = of_trial / *of_expert;
  criterion.points = points_of(ratio);
  criterion.reason = digits(ratio, 2) + " times the expert's " + std::move(expert_text) + ".";
  return criterion;
}

Criterion checkpoints(const TrialMetrics& trial) {
  Criterion criterion{"Checkpoints",
                      count_text(trial.checkpoints_reached) + " of " + count_text(trial.checkpoints),
                      {},
                      kCheckpointPoints,
                      {}};
  if (trial.checkpoints == 0) {
    criterion.reason = "The task has none.";
    return criterion;
  }
  criterion.points = kCheckpointPoints * static_cast<double>(trial.checkpoints_reached) /
                     static_cast<double>(trial.checkpoints);
  criterion.reason = "They count in their order, each once the tool has stayed there.";
  return criterion;
}

Criterion hard_touches(const TrialMetrics& trial) {
  Criterion criterion{"Hard touches", count_text(*trial.hard_touches), {}, kPoints, {}};
  if (trial.checkpoints > 0 && trial.checkpoints_reached == 0) {
    criterion.points = 0;
    criterion.reason = "They count once a checkpoint is reached.";
    return criterion;
  }
  criterion.points = std::max(0.0, kPoints - kPointsAHardTouch * static_cast<double>(*trial.hard_touches));
  criterion.reason = "Each costs " + digits(kPointsAHardTouch, 0) + " points; " +
                     in_seconds(trial.hard_touch_time) + " above the limit in all.";
  return criterion;
}

Criterion told(const char* name, std::string value, std::string reason) {
  return {name, std::move(value), {}, 0, std::move(reason)};
}

}  // namespace

std::string in_seconds(double time) {
  return digits(time, 1, "s");
}

std::string in_millimetres(double length) {
  const double millimetres = 1e3 * length;
  return digits(millimetres, millimetres < 10 ? 2 : millimetres < 100 ? 1 : 0, "mm");
}

std::string in_newtons(double force) {
  return digits(force, 2, "N");
}

Score score(const TrialMetrics& trial, const TrialMetrics* expert) {
  using Reference = std::optional<double>;
  // An expert who did not complete the task is none.
  const TrialMetrics* const best = expert != nullptr && expert->completed ? expert : nullptr;
  const char* const why_none = expert == nullptr ? "There is no expert to compare with."
                               : best == nullptr
                                   ? "The expert did not complete the task: there is nothing to compare with."
                                   : "The expert has no such figure to compare with.";
  Score all;
  std::vector<Criterion>& list = all.criteria;
  list.push_back(checkpoints(trial));
  list.push_back(beside_expert("Time", in_seconds(trial.time), trial.time,
                               best != nullptr && best->time > 0 ? Reference(best->time) : std::nullopt,
                               best != nullptr ? in_seconds(best->time) : "", trial.completed, why_none));
  list.push_back(beside_expert("Path", in_millimetres(trial.path), trial.path,
                               best != nullptr && best->path > 0 ? Reference(best->path) : std::nullopt,
                               best != nullptr ? in_millimetres(best->path) : "", trial.completed, why_none));
  list.push_back(beside_expert(
      "95th percentile of force", in_newtons(trial.force_95), std::max(trial.force_95, kLeastForce),
      best != nullptr ? Reference(std::max(best->force_95, kLeastForce)) : std::nullopt,
      best != nullptr ? in_newtons(best->force_95) : "", trial.completed, why_none));
  if (trial.hard_touches) list.push_back(hard_touches(trial));
  if (trial.smoothness)
    list.push_back(beside_expert(
        "Smoothness (spectral arc length)", digits(*trial.smoothness, 2), -*trial.smoothness,
        best != nullptr && best->smoothness ? Reference(-*best->smoothness) : std::nullopt,
        best != nullptr && best->smoothness ? digits(*best->smoothness, 2) : "", trial.completed, why_none));
  list.push_back(
      beside_expert("Touches on the way", count_text(trial.touches_on_the_way),
                    static_cast<double>(trial.touches_on_the_way) + kLeastTouches,
                    best != nullptr ? Reference(static_cast<double>(best->touches_on_the_way) + kLeastTouches)
                                    : std::nullopt,
                    best != nullptr ? count_text(best->touches_on_the_way) : "", trial.completed, why_none));
  // Counts that may be none have no ratio to tell.
  if (best != nullptr && trial.completed)
    list.back().reason = "The expert: " + count_text(best->touches_on_the_way) + ".";
  list.push_back(told("Mean force", in_newtons(trial.force_mean),
                      "Over " + in_seconds(trial.contact_time) + " of contact."));
  list.push_back(told("Peak force", in_newtons(trial.force_peak), "Of the scene on the tool."));
  list.push_back(
      told("Depth", in_millimetres(trial.depth_peak), "The deepest that a tick saw, by the distance field."));
  list.push_back(told("E_tau", digits(trial.torque_error, 3, "N m s"), "Torque of the coupling over time."));
  list.push_back(told("E_F", digits(trial.force_error, 2, "N s"), "Force of contact over time."));

  if (trial.guided) {
    for (Criterion& criterion : list) criterion.points.reset();
    list.insert(list.begin(),
                told("Guided", "yes", "A trial in which the expert's way was shown has no points."));
    return all;
  }
  double points = 0, most = 0;
  for (const Criterion& criterion : list) {
    if (!criterion.points) continue;
    points += *criterion.points;
    most += criterion.of;
  }
  if (best != nullptr && most > 0) all.total = 100 * points / most;
  return all;
}

}  // namespace fulcrum::session
