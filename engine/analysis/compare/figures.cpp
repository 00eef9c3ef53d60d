#include "engine/analysis/compare/figures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace fulcrum::analysis::compare {
namespace {

using report::Line;
using report::Marker;
using report::Plot;
using report::Series;

constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();  // lifts the pen
constexpr double kNever = std::numeric_limits<double>::infinity();

// Of the way from one variant to the next: where an interval stands beside its trials, and half of the bars
// at its ends.
constexpr double kBeside = 0.16, kBar = 0.025;

constexpr double kRoomForWords = 0.12;  // of the time that is shown

double largest_torque(const Comparison& comparison) {
  double largest = comparison.bad_above_Nm;
  for (const VariantRuns& runs : comparison.variants)
    for (const TimePoint& at : runs.course) largest = std::max(largest, at.torque);
  return largest;
}

// s, from the first moment of any variant that could be bad to the last, with room before it for the strips'
// names; the whole where there is none.
std::pair<double, double> stretch_with_torque(const Comparison& comparison) {
  double begin = kNever, end = -kNever, whole = 0;
  for (const VariantRuns& runs : comparison.variants) {
    for (const TimePoint& at : runs.course) {
      whole = std::max(whole, at.time);
      if (at.torque <= comparison.bad_above_Nm) continue;
      begin = std::min(begin, at.time);
      end = std::max(end, at.time);
    }
  }
  if (begin > end) return {0.0, whole};
  const double room = 1 + kRoomForWords * (end - begin);
  return {std::max(0.0, std::floor(begin - room)), std::min(whole, std::ceil(end + 1))};
}

// 0 to kDeepestShade.
int shade_of(double fraction) {
  return std::clamp(static_cast<int>(std::ceil(fraction * report::kDeepestShade)), 0, report::kDeepestShade);
}

}  // namespace

Plot metric_plot(const Comparison& comparison, Metric metric) {
  const MetricName name = name_of(metric);
  Plot plot;
  plot.title = std::string(name.symbol) + ": " + name.title;
  plot.height = metric == Metric::torque_error ? 260 : 150;
  for (const VariantRuns& runs : comparison.variants) plot.x.names.push_back(runs.name);
  plot.x.title = "variant";
  plot.y = {name.symbol, name.unit, report::Scale::linear, 0.0, {}};
  Series trials{"a trial", {}, Line::solid, Marker::circle, 6, false, true};
  Series interval{"95 % interval of the mean", {}, Line::solid, Marker::none, 0};
  Series mean{"mean", {}, Line::none, Marker::diamond, 0, false, true};
  for (std::size_t i = 0; i < comparison.variants.front().trials.size(); ++i) {
    for (std::size_t v = 0; v < comparison.variants.size(); ++v)
      trials.points.push_back(
          {static_cast<double>(v), comparison.variants[v].trials[i].value(metric).value_or(kNowhere)});
    trials.points.push_back({0, kNowhere});
  }
  for (std::size_t v = 0; v < comparison.variants.size(); ++v) {
    const Estimate estimate = estimate_of(comparison.variants[v], metric);
    if (!estimate.interval) continue;
    const double x = static_cast<double>(v) + kBeside;
    mean.points.push_back({x, estimate.mean});
    const double low = estimate.interval->low, high = estimate.interval->high;
    interval.points.insert(interval.points.end(), {{x - kBar, low},
                                                   {x + kBar, low},
                                                   {x, kNowhere},
                                                   {x, low},
                                                   {x, high},
                                                   {x, kNowhere},
                                                   {x - kBar, high},
                                                   {x + kBar, high},
                                                   {x, kNowhere}});
    plot.labels.push_back({{x, estimate.mean}, report::short_number(estimate.mean, 3), report::Side::above});
  }
  plot.series = {trials};
  if (!mean.points.empty()) plot.series.insert(plot.series.end(), {interval, mean});
  return plot;
}

Plot course_plot(const Comparison& comparison, std::size_t variant) {
  const VariantRuns& runs = comparison.variants[variant];
  Plot plot;
  plot.title = "Variant " + runs.name;
  plot.height = 190;
  const auto [begin, end] = stretch_with_torque(comparison);
  plot.x = {"time", "s", report::Scale::linear, begin, end};
  // Torque below, then a strip for each cue: rows of cells with gaps between them.
  const double top = 1.05 * largest_torque(comparison), strip = 0.09 * top;
  const double rows[] = {0, top, top + strip, top + 2 * strip, top + 2.5 * strip, top + 3.5 * strip};
  plot.y = {"|τ|", "N m", report::Scale::linear, 0.0, rows[5]};
  plot.cells.y_edges.assign(std::begin(rows), std::end(rows));
  const bool legend = variant == 0;
  const auto named = [legend](const char* name) { return legend ? name : ""; };
  plot.cells.bands = {
      {named("bad torque"), 1}, {named("cue, weak"), -1}, {"", -2}, {"", -3}, {named("cue, full"), -4}};
  double loudest = 0;
  for (const VariantRuns& each : comparison.variants)
    for (const TimePoint& at : each.course) loudest = std::max(loudest, at.vibration);
  const auto cue_band = [](double fraction) { return fraction > 0 ? shade_of(fraction) : -1; };
  Series torque{named("|τ|"), {}, Line::solid, Marker::none, report::kInk, false};
  Series bound{
      named("bad from here on, where no force explains it"), {}, Line::dashed, Marker::none, 6, false};
  std::vector<int> bad, vibration, ghost;
  for (const TimePoint& at : runs.course) {
    plot.cells.x_edges.push_back(at.time);
    bad.push_back(at.bad ? 0 : -1);
    vibration.push_back(loudest > 0 ? cue_band(at.vibration / loudest) : -1);
    ghost.push_back(cue_band(at.ghost));
    torque.points.push_back({at.time, at.torque});
  }
  if (!runs.course.empty()) plot.cells.x_edges.push_back(runs.course.back().time);
  bound.points = {{begin, comparison.bad_above_Nm}, {end, comparison.bad_above_Nm}};
  std::vector<int> empty(bad.size(), -1);
  for (const std::vector<int>* row : {&bad, &empty, &vibration, &empty, &ghost})
    plot.cells.band.insert(plot.cells.band.end(), row->begin(), row->end());
  plot.series = {bound, torque};
  plot.labels = {{{begin, 0.5 * (rows[2] + rows[3])}, "vibration", report::Side::right},
                 {{begin, 0.5 * (rows[4] + rows[5])}, "ghost", report::Side::right}};
  return plot;
}

}  // namespace fulcrum::analysis::compare
