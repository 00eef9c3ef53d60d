#include "engine/analysis/uniformity/figures.h"

#include <algorithm>
#include <cmath>

#include "engine/analysis/uniformity/inertia_limit.h"
#include "engine/analysis/uniformity/tables.h"

namespace fulcrum::analysis::uniformity {
namespace {

using report::Line;
using report::Marker;
using report::Plot;
using report::Scale;
using report::Series;
using report::short_number;

struct Look {
  const char* name;
  int hue;
  Marker marker;
};

Look look_of(InertiaMethod method) {
  switch (method) {
    case InertiaMethod::none:
      return {"none", report::kInk, Marker::none};
    case InertiaMethod::arm:
      return {"arm (method 1)", 1, Marker::none};
    default:
      return {"acceleration (method 2)", 0, Marker::none};
  }
}

}  // namespace

Plot stiffness_plot(const UniformityStudy& study) {
  Plot plot;
  plot.title = "Felt stiffness, over the one assigned";
  plot.x = {"assigned stiffness", "N/m", Scale::linear, 50.0, 650.0};
  plot.y = {"felt over assigned", "", Scale::linear, {}, {}};
  for (const double side : {1 + kStiffnessJnd, 1 - kStiffnessJnd})
    plot.series.push_back({side > 1 ? "just noticeable: 8 %" : "",
                           {{50, side}, {650, side}},
                           Line::dotted,
                           Marker::none,
                           2,
                           true});
  double shift = -6;  // N/m, so that bars lie side by side
  for (const InertiaMethod method : kMethods) {
    const Look look = look_of(method);
    Series means{look.name, {}, Line::solid, Marker::circle, look.hue};
    for (const double stiffness : kStiffnesses) {
      const StickSummary s = summary_of(study, method, stiffness);
      const double x = stiffness + shift, mean = s.felt / stiffness, bar = s.scatter / stiffness;
      means.points.push_back({x, mean});
      plot.series.push_back({"", {{x, mean - bar}, {x, mean + bar}}, Line::solid, Marker::none, look.hue});
    }
    plot.series.push_back(means);
    shift += 6;
  }
  return plot;
}

Plot torque_plot(const UniformityStudy& study, double stiffness) {
  Plot plot;
  plot.title = "Torque at the hand along the stick, ball of " + short_number(stiffness) + " N/m";
  plot.x = {"place touched, from the stage", "mm", Scale::linear, 0.0, 1e3 * kStickLength};
  plot.y = {"torque at the hand", "mN m", Scale::linear, {}, {}};
  Series wanted{"wanted, h × f", {}, Line::dotted, Marker::none, 2, true};
  Series low{"what nobody tells from it", {}, Line::solid, Marker::none, 2, false, true}, high = low;
  high.name.clear();
  for (const InertiaMethod method : kMethods) {
    const Look look = look_of(method);
    Series series{look.name, {}, Line::solid, Marker::circle, look.hue};
    for (const UniformityRow& row : study.rows) {
      if (row.method != method || row.stiffness != stiffness) continue;
      const double x = 1e3 * row.place, told = told_torque(row.wanted_torque);
      series.points.push_back({x, 1e3 * (row.wanted_torque + row.torque_error)});
      if (method != InertiaMethod::none) continue;
      wanted.points.push_back({x, 1e3 * row.wanted_torque});
      low.points.push_back({x, 1e3 * (row.wanted_torque - told)});
      high.points.push_back({x, 1e3 * (row.wanted_torque + told)});
    }
    plot.series.push_back(series);
  }
  plot.series.insert(plot.series.end(), {wanted, low, high});
  const double hand = 1e3 * study.path.held;
  plot.series.push_back({"the hand",
                         {{hand, wanted.points.front().y}, {hand, wanted.points.back().y}},
                         Line::dashed,
                         Marker::none,
                         report::kInk,
                         false,
                         true});
  return plot;
}

report::Panels torque_panels(const UniformityStudy& study) {
  report::Panels panels;
  panels.title = "Error of the torque at the hand, in units of what a person tells";
  panels.rows = {""};
  panels.bands = {{"below half", -2}, {"half to one: not told", -1}, {"one to two", 2}, {"above two", 4}};
  panels.down = kStiffnesses.size();
  panels.above = "600 N/m";
  panels.below = "100 N/m";
  for (const InertiaMethod method : kMethods) {
    panels.columns.push_back(look_of(method).name);
    std::vector<int> cells;
    for (auto stiffness = kStiffnesses.rbegin(); stiffness != kStiffnesses.rend(); ++stiffness) {
      for (const UniformityRow& row : study.rows) {
        if (row.method != method || row.stiffness != *stiffness) continue;
        const double over = std::abs(row.torque_error) / told_torque(row.wanted_torque);
        cells.push_back(over < 0.5 ? 0 : over < 1 ? 1 : over < 2 ? 2 : 3);
      }
    }
    panels.across = cells.size() / panels.down;
    panels.panels.push_back(std::move(cells));
  }
  return panels;
}

Plot lag_plot(const UniformityStudy& study) {
  Plot plot;
  plot.title = "Acceleration from position: lag against noise";
  plot.x = {"lag", "ms", Scale::logarithmic, 0.1, 50.0};
  plot.y = {"noise", "m/s² rms", Scale::logarithmic, {}, {}};
  for (const auto kind : {AccelerationEstimatorKind::kalman, AccelerationEstimatorKind::adaptive}) {
    const int hue = kind == AccelerationEstimatorKind::kalman ? 0 : 1;
    Series stated{std::string(name_of(kind)) + ", as stated", {}, Line::solid, Marker::none, hue};
    Series measured{std::string(name_of(kind)) + ", measured", {}, Line::none, Marker::circle, hue};
    for (const FilterRow& row : study.filters) {
      if (row.kind != kind) continue;
      stated.points.push_back({1e3 * row.lag, row.noise});
      measured.points.push_back({1e3 * row.measured_lag, row.measured_noise});
      if (kind == AccelerationEstimatorKind::kalman)
        plot.labels.push_back({stated.points.back(), "jerk " + short_number(row.jerk), report::Side::right});
    }
    plot.series.insert(plot.series.end(), {stated, measured});
  }
  return plot;
}

Plot cost_plot(const UniformityStudy& study) {
  Plot plot;
  plot.title = "Error on a hand's motion against run time";
  plot.x = {"run time of an update", "ns", Scale::logarithmic, {}, {}};
  plot.y = {"error", "m/s² rms", Scale::logarithmic, {}, {}};
  for (const auto kind : {AccelerationEstimatorKind::kalman, AccelerationEstimatorKind::adaptive}) {
    const bool first = kind == AccelerationEstimatorKind::kalman;
    Series series{
        std::string(name_of(kind)), {}, Line::none, first ? Marker::circle : Marker::square, first ? 0 : 1};
    for (const FilterRow& row : study.filters)
      if (row.kind == kind) series.points.push_back({row.cpu_ns, row.error});
    plot.series.push_back(series);
  }
  return plot;
}

namespace {

enum class Over { gain, hand_mass };

// Largest stable lag over one of the loop's figures: exactly, and to first order.
Plot limits_over(const UniformityStudy& study, Over over, const std::vector<double>& values) {
  Plot plot;
  plot.y = {"largest stable lag", "ms", Scale::logarithmic, 0.5, 100.0};
  int hue = 0;
  for (const double wall : {0.0, 300.0, 600.0}) {
    const std::string name = wall > 0 ? short_number(wall) + " N/m" : "nothing touched";
    Series exact{name, {}, Line::solid, Marker::none, hue}, delay{"", {}, Line::none, Marker::cross, hue};
    Series theory{wall > 0 ? "" : "to first order", {}, Line::dotted, Marker::none, hue};
    for (const double value : values) {
      InertiaLoop loop = study.hand;
      loop.wall_stiffness = wall;
      (over == Over::gain ? loop.gain : loop.hand_mass) = value;
      const double x = over == Over::gain ? value : 1e3 * value;
      exact.points.push_back({x, 1e3 * largest_filter_lag(loop)});
      delay.points.push_back({x, 1e3 * largest_delay(loop)});
      theory.points.push_back({x, 1e3 * first_order_lag(loop)});
    }
    plot.series.insert(plot.series.end(), {exact, theory, delay});
    ++hue;
  }
  const double from = over == Over::gain ? values.front() : 1e3 * values.front();
  const double to = over == Over::gain ? values.back() : 1e3 * values.back();
  plot.series.push_back({"the default filter",
                         {{from, 1e3 * study.filter_lag}, {to, 1e3 * study.filter_lag}},
                         Line::dashed,
                         Marker::none,
                         report::kInk});
  return plot;
}

}  // namespace

Plot limit_plot(const UniformityStudy& study) {
  std::vector<double> gains;
  for (int i = 8; i <= 20; ++i) gains.push_back(0.05 * i);
  Plot plot = limits_over(study, Over::gain, gains);
  plot.title = "How late m a may be: over the gain";
  plot.x = {"gain g", "", Scale::linear, gains.front(), gains.back()};
  return plot;
}

Plot mass_plot(const UniformityStudy& study) {
  std::vector<double> masses;
  for (int i = 1; i <= 12; ++i) masses.push_back(0.025 * i);
  Plot plot = limits_over(study, Over::hand_mass, masses);
  plot.title = "How late m a may be: over the hand's mass, g = 1";
  plot.x = {"mass of the hand", "g", Scale::linear, 1e3 * masses.front(), 1e3 * masses.back()};
  return plot;
}

Plot late_plot(const UniformityStudy& study) {
  Plot plot;
  const LateRun& run = study.late.back();
  plot.title = "A hand that presses on, with m a " + short_number(1e3 * run.lag, 2) + " ms late";
  plot.x = {"time", "s", Scale::linear, {}, {}};
  plot.y = {"height of the handle", "mm", Scale::linear, {}, {}};
  Series faded{"faded", {}, Line::solid, Marker::none, 0},
      unfaded{"not faded", {}, Line::solid, Marker::none, 1};
  constexpr std::size_t every = 4;
  for (std::size_t i = 0; i < run.way.size(); i += every) {
    const double t = static_cast<double>(i) * study.hand.tick_s;
    faded.points.push_back({t, 1e3 * run.way[i]});
    unfaded.points.push_back({t, 1e3 * run.way_unfaded[i]});
  }
  plot.series = {unfaded, faded};
  if (run.faded_at >= 0) {
    const auto at = static_cast<std::size_t>(run.faded_at / study.hand.tick_s);
    plot.series.push_back({"its energy is spent: it fades",
                           {{run.faded_at, 1e3 * run.way[at]}},
                           Line::none,
                           Marker::diamond,
                           3});
  }
  return plot;
}

}  // namespace fulcrum::analysis::uniformity
