#include "engine/app/results/table.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/report/csv.h"
#include "engine/session/score.h"

namespace fulcrum::app {
namespace {

std::string outcome_of(const session::Trial& trial) {
  const session::TrialMetrics& metrics = trial.metrics;
  if (metrics.completed) return session::in_seconds(metrics.time);
  return std::to_string(metrics.checkpoints_reached) + " of " + std::to_string(metrics.checkpoints) +
         (trial.whole ? "" : ", ended early");
}

// A star where the task was not the scenario's own.
std::string score_of_trial(const session::Trial& trial) {
  if (trial.metrics.guided) return "guided";
  const std::string score = trial.score ? report::short_number(std::round(*trial.score)) : "";
  return trial.changes.empty() ? score : score + "*";
}

}  // namespace

report::Table results_table(const std::vector<session::StoredTrial>& trials) {
  report::Table table{
      {"participant", "scenario", "began (UTC)", "completed", "score", "95 % force", "folder"}, {}};
  for (const session::StoredTrial& stored : trials) {
    const session::Trial& trial = stored.trial;
    std::string began = trial.began.substr(0, 16);
    if (began.size() == 16) began[10] = ' ';
    table.rows.push_back({stored.session.participant, trial.scenario, began, outcome_of(trial),
                          score_of_trial(trial), session::in_newtons(trial.metrics.force_95), trial.folder});
  }
  return table;
}

// A spreadsheet takes a cell that begins so for a formula.
std::string no_formula(const std::string& text) {
  return text.empty() || std::string_view("=+-@\t\r").find(text.front()) == std::string_view::npos
             ? text
             : "'" + text;
}

std::string results_csv(const std::vector<session::StoredTrial>& trials) {
  std::vector<std::string_view> columns = {"participant", "session", "trial", "scenario",    "began",
                                           "ended",       "device",  "hand",  "left_handed", "seed",
                                           "whole",       "guided",  "score"};
  const std::vector<std::string_view>& figures = session::metric_names();
  columns.insert(columns.end(), figures.begin(), figures.end());
  columns.insert(columns.end(), {"changes", "folder", "trace_sha256"});
  report::Csv csv(columns);
  for (const auto& [trial, session] : trials) {
    const std::string seed = std::to_string(trial.seed);  // of more digits than a double has
    const std::string scenario = no_formula(trial.scenario), device = no_formula(trial.device),
                      hand = no_formula(trial.hand), changes = no_formula(trial.changes),
                      folder = no_formula(trial.folder);
    std::vector<report::Csv::Cell> cells = {session.participant,
                                            session.uuid,
                                            trial.uuid,
                                            scenario,
                                            trial.began,
                                            trial.ended,
                                            device,
                                            hand,
                                            trial.left_handed ? 1.0 : 0.0,
                                            seed,
                                            trial.whole ? 1.0 : 0.0,
                                            trial.metrics.guided ? 1.0 : 0.0};
    cells.push_back(trial.score ? report::Csv::Cell(*trial.score) : report::Csv::Cell(std::string_view()));
    const auto values = named_values(trial.metrics);
    for (const std::string_view name : figures) {
      report::Csv::Cell cell = std::string_view();
      for (const auto& [known, value] : values)
        if (known == name) cell = value;
      cells.push_back(cell);
    }
    cells.emplace_back(changes);
    cells.emplace_back(folder);
    cells.emplace_back(trial.trace_sha256);
    csv.row(cells);
  }
  return csv.text();
}

std::string results_json(const std::vector<session::StoredTrial>& trials) {
  using Json = nlohmann::ordered_json;
  Json all = Json::array();
  for (const auto& [trial, session] : trials) {
    Json figures = Json::object(), events = Json::array();
    for (const auto& [name, value] : named_values(trial.metrics)) figures[name] = value;
    for (const session::TrialEvent& event : trial.events)
      events.push_back({{"time_s", event.time}, {"kind", name_of(event.kind)}, {"text", event.text}});
    all.push_back({{"participant", session.participant},
                   {"session", session.uuid},
                   {"trial", trial.uuid},
                   {"scenario", trial.scenario},
                   {"title", trial.title},
                   {"began", trial.began},
                   {"ended", trial.ended},
                   {"device", trial.device},
                   {"hand", trial.hand},
                   {"left_handed", trial.left_handed},
                   {"seed", trial.seed},
                   {"whole", trial.whole},
                   {"guided", trial.metrics.guided},
                   {"score", trial.score ? Json(*trial.score) : Json()},
                   {"figures", figures},
                   {"events", events},
                   {"changes", trial.changes},
                   {"folder", trial.folder},
                   {"trace_sha256", trial.trace_sha256},
                   {"program_version", session.program_version}});
  }
  // A name that is not UTF-8 must not cost the others their results.
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace fulcrum::app
