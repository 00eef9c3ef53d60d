#include "engine/app/device_test/report.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "haptics/math/number_text.h"

namespace fulcrum::app::device_test {
namespace {

// Of one kind: pushes, or turns.
report::Plot plot_of(const Findings& findings, bool turns, bool of_motion) {
  report::Plot plot;
  plot.title = of_motion ? "How the handle gave way" : "What was commanded";
  plot.x.title = "time since the push began";
  plot.x.unit = "s";
  plot.y.title = of_motion ? "way" : turns ? "torque" : "force";
  plot.y.unit = of_motion ? (turns ? "mrad" : "mm") : (turns ? "N m" : "N");
  plot.height = 240;
  const double scale = of_motion ? 1e3 : 1;
  int hue = 0;
  for (const PushTrace& push : findings.pushes) {
    if (push.turns != turns) continue;
    report::Series series;
    series.name = push.name;
    series.hue = hue++ % report::kHues;
    const std::vector<double>& values = of_motion ? push.moved : push.commanded;
    for (std::size_t i = 0; i < values.size(); ++i)
      series.points.push_back({push.time[i], scale * values[i]});
    plot.series.push_back(std::move(series));
  }
  return plot;
}

// Which share of the samples was younger than an age.
report::Plot plot_of_ages(std::vector<double> ages) {
  std::ranges::sort(ages);
  report::Plot plot;
  plot.title = "How old samples are";
  plot.x.title = "age";
  plot.x.unit = "ms";
  plot.x.low = 0;
  plot.y.title = "younger";
  plot.y.unit = "%";
  plot.y.low = 0;
  plot.y.high = 100;
  plot.height = 240;
  report::Series series;
  for (std::size_t i = 0; i < ages.size(); ++i)
    series.points.push_back(
        {1e3 * ages[i], 100 * static_cast<double>(i + 1) / static_cast<double>(ages.size())});
  plot.series.push_back(std::move(series));
  return plot;
}

report::Table measures_of(const Findings& findings) {
  report::Table table{.head = {"part", "measure", "value", "unit"}, .rows = {}};
  for (const Part& part : findings.parts)
    for (const Measure& measure : part.measures)
      table.rows.push_back({part.name, measure.name, number_text(measure.value), measure.unit});
  return table;
}

}  // namespace

Outcome outcome_of(const Findings& findings) {
  const auto any = [&](Outcome outcome) {
    return std::ranges::find(findings.parts, outcome, &Part::outcome) != findings.parts.end();
  };
  if (any(Outcome::bad)) return Outcome::bad;
  if (any(Outcome::odd)) return Outcome::odd;
  return any(Outcome::good) ? Outcome::good : Outcome::unknown;
}

report::Page page(const Findings& findings, std::string_view device, const report::Facts& about) {
  report::Page page("Device test: " + std::string(device));
  page.facts(about);
  page.heading("What was found");
  report::Facts parts;
  for (const Part& part : findings.parts)
    parts.emplace_back(part.name + ": " + std::string(name_of(part.outcome)), part.says);
  page.facts(parts);
  for (const bool turns : {false, true}) {
    if (std::ranges::find(findings.pushes, turns, &PushTrace::turns) == findings.pushes.end()) continue;
    page.heading(turns ? "Turns" : "Pushes");
    page.plot(plot_of(findings, turns, false),
              "Each grows for a second, and ends once the handle gives way.");
    page.plot(plot_of(findings, turns, true),
              "Along the push. A handle that went below zero went against it.");
  }
  if (!findings.ages.empty()) {
    page.heading("Samples");
    page.plot(plot_of_ages(findings.ages), "At each tick of the two seconds in which nothing touched it.");
  }
  page.heading("Figures");
  page.table(measures_of(findings));
  return page;
}

report::Csv csv(const Findings& findings) {
  report::Csv csv{"part", "outcome", "measure", "value", "unit"};
  for (const Part& part : findings.parts) {
    const std::string_view outcome = name_of(part.outcome);
    if (part.measures.empty()) csv.row({part.name, outcome, "", "", ""});
    for (const Measure& measure : part.measures)
      csv.row({part.name, outcome, measure.name, measure.value, measure.unit});
  }
  return csv;
}

nlohmann::ordered_json as_json(const Findings& findings) {
  using Json = nlohmann::ordered_json;
  Json parts = Json::array();
  for (const Part& part : findings.parts) {
    Json measures = Json::array();
    for (const Measure& measure : part.measures)
      measures.push_back({{"name", measure.name}, {"value", measure.value}, {"unit", measure.unit}});
    parts.push_back({{"part", part.name},
                     {"outcome", name_of(part.outcome)},
                     {"says", part.says},
                     {"measures", std::move(measures)}});
  }
  return {{"outcome", name_of(outcome_of(findings))}, {"parts", std::move(parts)}};
}

}  // namespace fulcrum::app::device_test
