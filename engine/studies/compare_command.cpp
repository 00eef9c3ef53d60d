#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "engine/analysis/compare/report.h"
#include "engine/analysis/compare/tables.h"
#include "engine/app/cli/exit_code.h"
#include "engine/app/cli/report_output.h"
#include "engine/app/cli/studies.h"
#include "engine/app/cli/terminal.h"
#include "engine/studies/commands.h"
#include "engine/studies/compare_trials.h"

namespace fulcrum::app {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const analysis::compare::Estimate& estimate) {
  Json json{{"n", estimate.n}, {"mean", nullptr}, {"low", nullptr}, {"high", nullptr}};
  if (estimate.n > 0) json["mean"] = estimate.mean;
  if (estimate.interval) {
    json["low"] = estimate.interval->low;
    json["high"] = estimate.interval->high;
  }
  return json;
}

Json to_json(const YieldingDesc& yields) {
  return {{"reaction_s", yields.reaction},
          {"gain_rad_per_s", yields.gain},
          {"spread", yields.spread},
          {"full_vibration_N", yields.full_vibration},
          {"least_vibration_N", yields.least_vibration},
          {"felt_error_rad", yields.felt_error_rad},
          {"seen_error_rad", yields.seen_error_rad},
          {"recovery_s", yields.recovery}};
}

Json metrics_json(const analysis::compare::Comparison& comparison) {
  Json metrics = Json::array();
  for (const analysis::compare::Metric metric : analysis::compare::kMetrics) {
    const analysis::compare::MetricName name = analysis::compare::name_of(metric);
    for (const analysis::compare::VariantRuns& runs : comparison.variants) {
      Json row{{"metric", name.csv}, {"unit", name.unit}, {"variant", runs.name}};
      row.update(to_json(analysis::compare::estimate_of(runs, metric)));
      metrics.push_back(std::move(row));
    }
  }
  return metrics;
}

Json differences_json(const analysis::compare::Comparison& comparison) {
  Json differences = Json::array();
  const analysis::compare::VariantRuns& reference = comparison.variants.front();
  for (const analysis::compare::Metric metric : analysis::compare::kMetrics) {
    for (const analysis::compare::VariantRuns& runs : comparison.variants) {
      if (&runs == &reference) continue;
      Json row{{"metric", analysis::compare::name_of(metric).csv},
               {"variant", runs.name},
               {"minus", reference.name}};
      row.update(to_json(analysis::compare::difference_of(runs, reference, metric)));
      differences.push_back(std::move(row));
    }
  }
  return differences;
}

Json trials_json(const analysis::compare::Comparison& comparison) {
  Json trials = Json::array();
  for (const analysis::compare::VariantRuns& runs : comparison.variants) {
    for (const analysis::compare::Trial& trial : runs.trials) {
      Json row{{"variant", runs.name}, {"seed", trial.seed}};
      for (const analysis::compare::Metric metric : analysis::compare::kMetrics) {
        const std::optional<double> value = trial.value(metric);
        row[analysis::compare::name_of(metric).csv] = value ? Json(*value) : Json(nullptr);
      }
      row["fault"] = trial.fault.empty() ? Json(nullptr) : Json(trial.fault);
      trials.push_back(std::move(row));
    }
  }
  return trials;
}

Json to_json(const analysis::compare::Comparison& comparison) {
  return {{"about", analysis::compare::reservation(comparison)},
          {"scenario", comparison.scenario},
          {"device", comparison.device},
          {"hand", comparison.hand.empty() ? Json(nullptr) : Json(comparison.hand)},
          {"yields", comparison.yields ? to_json(*comparison.yields) : Json(nullptr)},
          {"tape", comparison.tape.empty() ? Json(nullptr) : Json(comparison.tape)},
          {"confidence", analysis::compare::kConfidence},
          {"metrics", metrics_json(comparison)},
          {"differences", differences_json(comparison)},
          {"trials", trials_json(comparison)}};
}

// What was asked for, with what was left to its default.
std::string command_line(const CompareOptions& options) {
  std::string text = "fulcrum compare " + options.run.scenario + " --variants ";
  for (const TorqueVariant variant : options.variants)
    text.append(variant == options.variants.front() ? "" : ",").append(name_of(variant));
  if (options.tape.empty())
    text += " --hand " + options.hand + " --trials " + std::to_string(options.trials);
  else
    text += " --tape " + options.tape;
  for (const std::string& change : options.run.overrides) text += " --set " + change;
  return text;
}

int compare_command(const CompareOptions& options) {
  constexpr std::string_view files[] = {analysis::compare::kCompareCsvName,
                                        analysis::compare::kCompareJsonName,
                                        analysis::compare::kComparePageName};
  const std::optional<Prepared> prepared = prepare(options.run.scenario, options.run.overrides);
  if (!prepared) return kError;
  if (const auto error = nothing_to_compare(*prepared, options)) {
    complain(error->sentence);
    return kError;
  }
  const auto place = report_place("compare", options.run, files);
  if (!place) return kError;
  ProgressBar bar;
  analysis::compare::Comparison comparison =
      run_trials(*prepared, options, [&bar](double fraction) { bar.show("Running the trials", fraction); });
  bar.clear();
  comparison.command = command_line(options);
  const std::string json = to_json(comparison).dump(2) + "\n";
  const auto folder = write_report(
      *place, {{analysis::compare::kCompareCsvName, analysis::compare::compare_csv(comparison).text()},
               {analysis::compare::kCompareJsonName, json},
               {analysis::compare::kComparePageName, analysis::compare::compare_page(comparison).html()}});
  if (!folder) return kError;
  if (options.run.json) {
    std::printf("%s", json.c_str());
    return kCompleted;
  }
  std::printf("%s\n", analysis::compare::reservation(comparison));
  print_table(analysis::compare::compare_table(comparison));
  if (comparison.variants.size() > 1 && comparison.variants.front().trials.size() > 1)
    print_table(analysis::compare::difference_table(comparison));
  std::printf("Plots and every trial lie in %s\n", bold(folder->string()).c_str());
  return kCompleted;
}

}  // namespace

void add_compare(Program& program) {
  const auto options = std::make_shared<CompareOptions>();
  program.add(
      kCompareStudy.name, kCompareStudy.about,
      [options](Arguments& arguments) {
        arguments.required({"scenario", "NAME|FILE", "Its name (fulcrum list) or file"},
                           options->run.scenario);
        arguments.text(
            {"--variants", "A,B,C", "Of A (no cue), B (vibration), C (vibration and ghost); default A,B,C"},
            [options](const std::string& text) { return read_variants(text, options->variants); });
        CLI::Option* hand = arguments.text(
            {"--hand", "HAND", "The simulated hand (default: yielding, where the scenario has it)"},
            options->hand);
        CLI::Option* trials =
            arguments.count({"--trials", "N", "Of each variant (default 20)"}, options->trials, 1, 10000);
        CLI::Option* tape = arguments.text(
            {"--tape", "FILE", "A recorded motion, tape or trace.csv, instead of the hand: one trial"},
            options->tape);
        Arguments::exclude(tape, hand);
        Arguments::exclude(tape, trials);
        arguments.overrides(options->run.overrides);
        arguments.out(options->run);
        arguments.json("Print compare.json", options->run.json);
      },
      [options] { return compare_command(*options); });
}

}  // namespace fulcrum::app
