#include "engine/session/score.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string_view>

namespace fulcrum::session {
namespace {

// Of the expert's figure: up to the first there are all points, from the second on none, and evenly fewer
// between.
constexpr double kAllUpTo = 1.5, kNoneFrom = 4;
constexpr double kLeastForce = 0.1;  // N, below which two forces do not differ
constexpr double kLeastTouches = 1;
constexpr double kShareOfAFault = 0.2;  // of the points, that each hard touch, slip or trespass costs

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

double points_of(double ratio, double of) {
  return of * std::clamp((kNoneFrom - ratio) / (kNoneFrom - kAllUpTo), 0.0, 1.0);
}

// A figure that is better the smaller it is, beside the expert's.
Criterion beside_expert(const char* name, double of, std::string value, double of_trial,
                        std::optional<double> of_expert, std::string expert_text, bool completed,
                        const char* why_none) {
  Criterion criterion{name, std::move(value), {}, of, {}};
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
  criterion.points = points_of(ratio, of);
  criterion.reason = digits(ratio, 2) + " times the expert's " + std::move(expert_text) + ".";
  return criterion;
}

Criterion checkpoints(const TrialMetrics& trial, double of) {
  Criterion criterion{"Checkpoints",
                      count_text(trial.checkpoints_reached) + " of " + count_text(trial.checkpoints),
                      {},
                      of,
                      {}};
  if (trial.checkpoints == 0) {
    criterion.reason = "The task has none.";
    return criterion;
  }
  criterion.points =
      of * static_cast<double>(trial.checkpoints_reached) / static_cast<double>(trial.checkpoints);
  criterion.reason = "Each counts once the tool has stayed there, or done there what is asked for.";
  return criterion;
}

Criterion optional_checkpoints(const TrialMetrics& trial, double of) {
  return {"Optional checkpoints",
          count_text(trial.optional_reached) + " of " + count_text(trial.optional_checkpoints),
          of * static_cast<double>(trial.optional_reached) / static_cast<double>(trial.optional_checkpoints),
          of, "The task is completed without them, too."};
}

// What should not be, each at a share of the points.
Criterion faults(const TrialMetrics& trial, const char* name, std::int64_t count, double of,
                 const std::string& more) {
  Criterion criterion{name, count_text(count), {}, of, {}};
  if (trial.checkpoints > 0 && trial.checkpoints_reached == 0) {
    criterion.points = 0;
    criterion.reason = "They count once a checkpoint is reached.";
    return criterion;
  }
  criterion.points = of * std::max(0.0, 1 - kShareOfAFault * static_cast<double>(count));
  const double cost = kShareOfAFault * of;
  criterion.reason = "Each costs " + digits(cost, cost == std::round(cost) ? 0 : 1) + " points" + more + '.';
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

Score score(const TrialMetrics& trial, const TrialMetrics* expert, const scenario::ScoreWeights& weights) {
  // An expert who did not complete the task is none.
  const TrialMetrics* const best = expert != nullptr && expert->completed ? expert : nullptr;
  const char* const why_none = expert == nullptr ? "There is no expert to compare with."
                               : best == nullptr
                                   ? "The expert did not complete the task: there is nothing to compare with."
                                   : "The expert has no such figure to compare with.";
  Score all;
  std::vector<Criterion>& list = all.criteria;
  // read: the figure, none where there is nothing to compare; text: how it is told.
  const auto compare = [&](const char* name, double of, auto read, auto text) {
    const std::optional<double> of_trial = read(trial);
    const std::optional<double> of_expert = best != nullptr ? read(*best) : std::nullopt;
    list.push_back(beside_expert(name, of, text(trial), of_trial.value_or(0), of_expert,
                                 best != nullptr ? text(*best) : "", trial.completed, why_none));
  };
  using Figure = std::optional<double>;
  const auto above_none = [](double value) { return value > 0 ? Figure(value) : std::nullopt; };
  list.push_back(checkpoints(trial, weights.checkpoints));
  if (trial.optional_checkpoints > 0) list.push_back(optional_checkpoints(trial, weights.optional));
  compare(
      "Time", weights.time, [&](const TrialMetrics& m) { return above_none(m.time); },
      [](const TrialMetrics& m) { return in_seconds(m.time); });
  compare(
      "Path", weights.path, [&](const TrialMetrics& m) { return above_none(m.path); },
      [](const TrialMetrics& m) { return in_millimetres(m.path); });
  compare(
      "95th percentile of force", weights.force,
      [](const TrialMetrics& m) { return Figure(std::max(m.force_95, kLeastForce)); },
      [](const TrialMetrics& m) { return in_newtons(m.force_95); });
  if (trial.hard_touches)
    list.push_back(faults(trial, "Hard touches", *trial.hard_touches, weights.hard_touches,
                          "; " + in_seconds(trial.hard_touch_time) + " above the limit in all"));
  if (trial.slips)
    list.push_back(faults(trial, "Slips", *trial.slips, weights.slips, ": off a line or out of a bore"));
  if (trial.trespasses)
    list.push_back(faults(trial, "Trespasses", *trial.trespasses, weights.avoid,
                          "; " + in_seconds(trial.trespass_time) + " in what is to be avoided in all"));
  if (trial.smoothness)
    compare(
        "Smoothness (spectral arc length)", weights.smoothness,
        [](const TrialMetrics& m) { return m.smoothness ? Figure(-*m.smoothness) : std::nullopt; },
        [](const TrialMetrics& m) { return m.smoothness ? digits(*m.smoothness, 2) : std::string(); });
  compare(
      "Touches on the way", weights.touches,
      [](const TrialMetrics& m) { return Figure(static_cast<double>(m.touches_on_the_way) + kLeastTouches); },
      [](const TrialMetrics& m) { return count_text(m.touches_on_the_way); });
  // Counts that may be none have no ratio to tell.
  if (best != nullptr && trial.completed)
    list.back().reason = "The expert: " + count_text(best->touches_on_the_way) + ".";
  list.push_back(told("Mean force", in_newtons(trial.force_mean),
                      "Over " + in_seconds(trial.contact_time) + " of contact."));
  list.push_back(told("Peak force", in_newtons(trial.force_peak), "Of the scene on the tool."));
  list.push_back(told("Depth", in_millimetres(trial.depth_peak), "The deepest that a tick saw."));
  list.push_back(told("E_tau", digits(trial.torque_error, 3, "N m s"), "Torque of the coupling over time."));
  list.push_back(told("E_F", digits(trial.force_error, 2, "N s"), "Force of contact over time."));

  if (trial.guided) {
    for (Criterion& criterion : list) criterion.points.reset();
    list.insert(list.begin(),
                told("Guided", "yes", "A trial in which the expert's way was shown has no points."));
    return all;
  }
  double points = 0, most = 0;
  for (Criterion& criterion : list) {
    if (criterion.of <= 0) criterion.points.reset();  // told, and not judged
    if (!criterion.points) continue;
    points += *criterion.points;
    most += criterion.of;
  }
  const bool without_expert =
      weights.time + weights.path + weights.force + weights.smoothness + weights.touches <= 0;
  if ((best != nullptr || without_expert) && most > 0) all.total = 100 * points / most;
  return all;
}

}  // namespace fulcrum::session
