#include "engine/session/trial_page.h"

#include <algorithm>
#include <cmath>

#include "engine/report/page.h"

namespace fulcrum::session {
namespace {

constexpr double kPlotHeight = 170;      // px
constexpr std::size_t kMostListed = 60;  // events in the table

report::Series curve_of(const Envelope& envelope, double scale, int hue) {
  report::Series series{.name = "", .points = {}, .line = report::Line::solid, .hue = hue};
  for (std::size_t i = 0; i < envelope.largest().size(); ++i)
    series.points.push_back({envelope.interval() * static_cast<double>(i), scale * envelope.largest()[i]});
  return series;
}

double top_of(const Envelope& envelope, double scale, double least) {
  const auto largest = std::ranges::max_element(envelope.largest());
  return 1.2 * std::max(least, largest == envelope.largest().end() ? 0 : scale * *largest);
}

// A line across the plot at the time of each checkpoint, and its number where it is asked for.
void add_checkpoints(report::Plot& plot, const Trial& trial, double top, bool numbered) {
  std::size_t count = 0;
  for (const TrialEvent& event : trial.events) {
    if (event.kind != TrialEvent::Kind::checkpoint) continue;
    plot.series.push_back({.name = count == 0 ? "a checkpoint counts" : "",
                           .points = {{event.time, 0}, {event.time, top}},
                           .line = report::Line::dotted,
                           .hue = report::kInk,
                           .faint = true});
    if (++count; numbered)
      plot.labels.push_back({{event.time, 0.93 * top}, std::to_string(count), report::Side::left});
  }
}

struct PlotWords {
  const char* title;
  const char* axis;
  const char* unit;
};

report::Plot plot_of(const PlotWords& words, const Envelope& envelope, double scale, double least, int hue,
                     const Trial& trial, bool numbered) {
  const double top = top_of(envelope, scale, least);
  const double end = std::max(trial.metrics.time, 1e-3);
  report::Plot plot{.title = words.title,
                    .x = {"Time", "s", report::Scale::linear, 0.0, end},
                    .y = {words.axis, words.unit, report::Scale::linear, 0.0, top},
                    .cells = {},
                    .series = {curve_of(envelope, scale, hue)},
                    .labels = {},
                    .height = kPlotHeight};
  add_checkpoints(plot, trial, top, numbered);
  return plot;
}

void add_limit(report::Plot& plot, double limit, double end) {
  plot.series.push_back({.name = "the limit of a hard touch",
                         .points = {{0, limit}, {end, limit}},
                         .line = report::Line::dashed,
                         .hue = 1});
}

std::string outcome(const Trial& trial) {
  const TrialMetrics& metrics = trial.metrics;
  std::string text = metrics.completed ? "Completed in " : "Not completed, after ";
  text += in_seconds(metrics.time);
  if (!metrics.completed && metrics.checkpoints > 0)
    text += ", with " + std::to_string(metrics.checkpoints_reached) + " of " +
            std::to_string(metrics.checkpoints) + " checkpoints";
  return text + ".";
}

report::Table criteria(const Score& score) {
  report::Table table{{"", "This trial", "Points", "Why"}, {}, true};
  for (const Criterion& criterion : score.criteria) {
    std::string points = "not judged";
    if (criterion.points)
      points = report::short_number(*criterion.points, 3) + " of " + report::short_number(criterion.of, 3);
    table.rows.push_back({criterion.name, criterion.value, criterion.of > 0 ? points : "", criterion.reason});
  }
  return table;
}

report::Table events(const Trial& trial) {
  report::Table table{{"What happened", "Time (s)", "Which"}, {}, true};
  std::size_t checkpoint = 0;
  for (const TrialEvent& event : trial.events) {
    if (table.rows.size() == kMostListed) break;
    std::string what(name_of(event.kind));
    if (event.kind == TrialEvent::Kind::checkpoint) what += ' ' + std::to_string(++checkpoint);
    table.rows.push_back({std::move(what), report::short_number(event.time, 4), event.text});
  }
  return table;
}

}  // namespace

std::string trial_html(const TrialPage& of) {
  const Trial& trial = of.trial;
  report::Page page(trial.title.empty() ? trial.scenario : trial.title);
  if (!of.about.empty()) page.paragraph(of.about);
  std::string verdict = outcome(trial);
  if (trial.metrics.guided) verdict += " Guided: no points.";
  if (of.score.total) verdict += " " + report::short_number(std::round(*of.score.total)) + " of 100 points.";
  page.note(verdict);
  for (const std::string& sentence : of.faults) page.paragraph(sentence);

  report::Facts facts;
  if (!of.participant.empty()) facts.emplace_back("Participant", of.participant);
  facts.emplace_back("Scenario", trial.scenario);
  facts.emplace_back("Began", trial.began);
  facts.emplace_back("Device", trial.device + (trial.left_handed ? ", in the left hand" : ""));
  if (!trial.hand.empty()) facts.emplace_back("Simulated hand", trial.hand);
  if (of.expert_time) facts.emplace_back("The expert's time", in_seconds(*of.expert_time));
  facts.emplace_back("Seed", std::to_string(trial.seed));
  if (!of.heard.empty()) facts.emplace_back("Heard", of.heard);
  page.facts(facts);

  page.heading("Score");
  page.table(criteria(of.score));
  page.paragraph(
      "Points are out of those that can be judged. The expert is the scenario's own hand, a program, on the "
      "simulated "
      "device: its figures show what is possible, not what people do.");

  page.heading("The trial over time");
  page.paragraph("Each curve shows the largest value of every interval of " +
                 report::short_number(1e3 * of.curves.force.interval(), 3) + " ms.");
  const double end = std::max(trial.metrics.time, 1e-3);
  report::Plot force = plot_of({"Force of contact", "Force", "N"}, of.curves.force, 1, 0.5, 0, trial, true);
  if (of.hard_touch) add_limit(force, *of.hard_touch, end);
  page.plot(
      force,
      "What the scene does to the tool; its weight is no part of it. The numbers are the checkpoints'.");
  page.plot(plot_of({"Torque of contact", "Torque", "N mm"}, of.curves.torque, 1e3, 5, 3, trial, false),
            "About the tool's centre of mass.");
  page.plot(plot_of({"Depth", "Depth", "mm"}, of.curves.depth, 1e3, 0.1, 4, trial, false),
            "Of the deepest point of the tool's surface, as ticks saw it.");
  page.plot(plot_of({"Speed", "Speed", "mm/s"}, of.curves.speed, 1e3, 10, 2, trial, false),
            "Of the point of the tool that has to be at the checkpoints.");

  if (!trial.events.empty()) {
    page.heading("Events");
    page.table(events(trial));
    if (trial.events.size() > kMostListed)
      page.paragraph("The first " + std::to_string(kMostListed) + " of " +
                     std::to_string(trial.events.size()) + ".");
  }
  if (!of.limits.empty()) {
    page.heading("Limits that were applied");
    for (const std::string& sentence : of.limits) page.paragraph(sentence);
  }
  if (of.age) {
    page.heading("From hand to pixel");
    page.paragraph(
        "How old the tool's pose is when a picture with it is handed to the screen. Tick: from the device's "
        "own measurement until the tick with it has ended. Wait: until a picture takes that pose, which is "
        "the last thing before it is submitted. Draw: until the graphics device is done. Show: until the "
        "picture is the screen's, or the headset's. What these need then to light up is not known here.");
    page.table(of.age->stages);
    page.plot(of.age->frames, "Of all pictures of the trial, the part that took no longer.");
  }
  if (!of.replay_command.empty()) {
    page.heading("To repeat it");
    page.paragraph("The trial's tape holds every tick; this repeats it and compares every bit:");
    page.command(of.replay_command);
  }
  return page.html();
}

}  // namespace fulcrum::session
