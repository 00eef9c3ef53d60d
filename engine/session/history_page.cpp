#include "engine/session/history_page.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/report/page.h"
#include "engine/session/score.h"

namespace fulcrum::session {
namespace {

using Value = std::optional<double> (*)(const Trial&);

// One scenario's trials, by participant, each in its order.
using ByParticipant = std::map<std::string, std::vector<const Trial*>>;

std::size_t most_trials(const ByParticipant& people) {
  std::size_t most = 0;
  for (const auto& [name, trials] : people) most = std::max(most, trials.size());
  return most;
}

report::Plot over_trials(const ByParticipant& people, const char* title, const char* unit, Value value,
                         std::optional<double> top) {
  report::Plot plot{
      .title = title,
      .x = {"Trial", "", report::Scale::linear, 0.5, static_cast<double>(most_trials(people)) + 0.5},
      .y = {title, unit, report::Scale::linear, 0.0, top},
      .cells = {},
      .series = {},
      .labels = {},
      .height = 220};
  int hue = 0;
  for (const auto& [name, trials] : people) {
    report::Series series{.name = name,
                          .points = {},
                          .line = report::Line::solid,
                          .marker = static_cast<report::Marker>(1 + hue / report::kHues % 5),
                          .hue = hue % report::kHues};
    for (std::size_t i = 0; i < trials.size(); ++i)
      if (const std::optional<double> y = value(*trials[i]))
        series.points.push_back({static_cast<double>(i + 1), *y});
    plot.series.push_back(std::move(series));
    ++hue;
  }
  return plot;
}

std::optional<double> score_of(const Trial& trial) {
  return trial.score;
}

std::optional<double> completion_of(const Trial& trial) {
  return trial.metrics.completed ? std::optional(trial.metrics.time) : std::nullopt;
}

std::optional<double> force_of(const Trial& trial) {
  return trial.metrics.force_95;
}

report::Table table_of(const ByParticipant& people) {
  report::Table table{{"Participant", "Began", "Outcome", "Score", "95 % force", "Path", "Report"}, {}};
  for (const auto& [name, trials] : people)
    for (const Trial* trial : trials) {
      const TrialMetrics& metrics = trial->metrics;
      table.rows.push_back({name, trial->began.substr(0, 16),
                            metrics.completed ? in_seconds(metrics.time)
                                              : std::to_string(metrics.checkpoints_reached) + " of " +
                                                    std::to_string(metrics.checkpoints),
                            trial->score ? report::short_number(std::round(*trial->score)) : "",
                            in_newtons(metrics.force_95), in_millimetres(metrics.path), trial->folder});
    }
  return table;
}

}  // namespace

std::string history_html(const std::vector<StoredTrial>& trials) {
  std::map<std::string, ByParticipant> scenarios;
  std::map<std::string, std::string> titles;
  for (const StoredTrial& stored : trials) {
    if (!stored.trial.whole || !stored.trial.changes.empty() || stored.trial.metrics.guided) continue;
    scenarios[stored.trial.scenario][stored.session.participant].push_back(&stored.trial);
    titles[stored.trial.scenario] = stored.trial.title;
  }
  report::Page page("Results over trials");
  if (scenarios.empty())
    page.paragraph("There is no trial that came to its end, of a task as its scenario has it, unguided.");
  for (const auto& [scenario, people] : scenarios) {
    page.heading(titles[scenario] + " (" + scenario + ")");
    page.plot(over_trials(people, "Score", "of 100", score_of, 100.0), "Every trial that came to its end.");
    page.plot(over_trials(people, "Time to completion", "s", completion_of, std::nullopt),
              "Trials that were not completed have none.");
    page.plot(over_trials(people, "95th percentile of force", "N", force_of, std::nullopt),
              "Of contact: what the scene does to the tool.");
    page.table(table_of(people));
  }
  return page.html();
}

}  // namespace fulcrum::session
