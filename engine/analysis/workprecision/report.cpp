#include "engine/analysis/workprecision/report.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fulcrum::analysis::workprecision {
namespace {

using report::Line;
using report::Marker;
using report::Plot;
using report::Scale;
using report::Series;
using report::short_number;

constexpr int kDigits = 3;

std::string number(double value) {
  return short_number(value, kDigits);
}

std::vector<std::string> methods(const WorkStudy& study) {
  std::vector<std::string> names;
  for (const WorkPoint& point : study.points)
    if (std::find(names.begin(), names.end(), point.method) == names.end()) names.push_back(point.method);
  return names;
}

std::vector<WorkPoint> points_of(const WorkStudy& study, const std::string& method) {
  std::vector<WorkPoint> points;
  std::copy_if(study.points.begin(), study.points.end(), std::back_inserter(points),
               [&](const WorkPoint& point) { return point.method == method; });
  return points;
}

std::string error_title(const WorkStudy& study) {
  return study.error_unit.empty() ? "error, of the truth" : "error";
}

template <class X>
Plot plot_of(const WorkStudy& study, const std::string& title, const report::AxisDesc& x, const X& x_of) {
  Plot plot;
  plot.title = title;
  plot.x = x;
  plot.y = {error_title(study), study.error_unit, Scale::logarithmic, {}, {}};
  constexpr Marker markers[] = {Marker::circle, Marker::square, Marker::triangle, Marker::diamond};
  int hue = 0;
  for (const std::string& method : methods(study)) {
    Series series;
    series.name = method;
    series.hue = hue;
    series.marker = markers[static_cast<std::size_t>(hue++) % std::size(markers)];
    for (const WorkPoint& point : points_of(study, method))
      series.points.push_back({x_of(point), point.error});
    plot.series.push_back(series);
  }
  return plot;
}

Plot cost_plot(const WorkStudy& study) {
  Plot plot = plot_of(study, "Error over cost", {"processor time", "µs", Scale::logarithmic, {}, {}},
                      [](const WorkPoint& point) { return point.cpu_us; });
  Series front;
  front.name = "Pareto front";
  front.line = Line::dashed;
  front.marker = Marker::cross;  // a front of one setting has no line
  front.hue = report::kInk;
  front.strong = true;
  std::vector<report::Point> all;
  for (const WorkPoint& point : study.points) all.push_back({point.cpu_us, point.error});
  front.points = report::pareto_front(all);
  plot.series.push_back(front);
  return plot;
}

report::Table order_table(const WorkStudy& study) {
  report::Table table{
      {"method", study.parameter, "error" + (study.error_unit.empty() ? "" : " (" + study.error_unit + ")"),
       "processor (µs)", "order", "expected"},
      {}};
  for (const WorkPoint& point : study.points) {
    std::string expected;
    for (const auto& [method, order] : study.expected_order)
      if (method == point.method) expected = number(order);
    table.rows.push_back({point.method, number(point.value), number(point.error), number(point.cpu_us),
                          point.order == 0 ? "" : number(point.order), expected});
  }
  return table;
}

}  // namespace

double advantage(const WorkStudy& study, const std::string& method) {
  const std::vector<WorkPoint> ours = points_of(study, method);
  double smallest = std::numeric_limits<double>::infinity();
  for (const WorkPoint& paid : points_of(study, study.baseline)) {
    double best = 0;
    for (const WorkPoint& point : ours)
      if (point.cpu_us <= paid.cpu_us && (best == 0 || point.error < best)) best = point.error;
    if (best > 0) smallest = std::min(smallest, paid.error / best);
  }
  return std::isfinite(smallest) ? smallest : 0.0;
}

report::Table advantage_table(const std::vector<WorkStudy>& studies) {
  report::Table table{{"truth", "method", "against", "error smaller by", number(kGoal) + " times"}, {}};
  for (const WorkStudy& study : studies) {
    if (study.baseline.empty()) continue;
    for (const std::string& method : methods(study)) {
      if (method == study.baseline) continue;
      const double times = advantage(study, method);
      table.rows.push_back({study.truth, method, study.baseline, times > 0 ? number(times) : "dearer",
                            times >= kGoal ? "met" : "missed"});
    }
  }
  return table;
}

std::string goal_sentence(const std::vector<WorkStudy>& studies) {
  std::string missed;
  int compared = 0, met = 0;
  for (const std::vector<std::string>& row : advantage_table(studies).rows) {
    ++compared;
    if (row.back() == "met")
      ++met;
    else
      missed += (missed.empty() ? "" : "; ") + row[0] + ", " + row[1] + " (" + row[3] + ")";
  }
  return "For the cost of each setting of the classic method or less, a contact force at least " +
         number(kGoal) + " times nearer to the truth is the goal: met by " + std::to_string(met) + " of " +
         std::to_string(compared) + (missed.empty() ? "." : ", missed by: " + missed + ".");
}

report::Csv work_csv(const std::vector<WorkStudy>& studies) {
  report::Csv csv{"truth", "method", "parameter", "value", "error", "error_unit", "cpu_us", "order"};
  for (const WorkStudy& study : studies) {
    for (const WorkPoint& point : study.points)
      csv.row({study.truth, point.method, study.parameter, point.value, point.error, study.error_unit,
               point.cpu_us, point.order});
  }
  return csv;
}

report::Table work_table(const std::vector<WorkStudy>& studies) {
  report::Table table{{"truth", "method", "finest setting", "error", "processor (µs)", "order", "expected"},
                      {}};
  for (const WorkStudy& study : studies) {
    for (const std::string& method : methods(study)) {
      const WorkPoint finest = points_of(study, method).back();
      std::string expected;
      for (const auto& [name, order] : study.expected_order)
        if (name == method) expected = number(order);
      table.rows.push_back({study.truth, method, study.parameter + " " + number(finest.value),
                            number(finest.error) + (study.error_unit.empty() ? "" : " " + study.error_unit),
                            number(finest.cpu_us), finest.order == 0 ? "" : number(finest.order), expected});
    }
  }
  return table;
}

report::Page work_page(const std::vector<WorkStudy>& studies) {
  report::Page page("Error against run time");
  page.command("fulcrum workprecision");
  page.paragraph(
      "Each choice an author has costs processor time and leaves an error. Here each is measured against a "
      "truth that is known without it: choose the point on the front that you can pay for. Times are "
      "processor "
      "time on the machine that made this page; they compare methods, not machines.");
  page.paragraph(
      "The rounds of the responses static and constraint, and the step below which they end, are fixed in "
      "the "
      "program: there is no solver tolerance for an author to choose, and none is measured. What they leave "
      "over is part of every error below.");
  page.heading("Against classic voxels");
  page.paragraph(goal_sentence(studies));
  page.table(advantage_table(studies));
  page.heading("The finest setting of each method");
  page.table(work_table(studies));
  for (const WorkStudy& study : studies) {
    page.heading("Truth: " + study.truth);
    page.paragraph(study.text);
    page.plot(cost_plot(study),
              "Lower and further left is better. Crosses mark the settings that no other "
              "beats in both.");
    page.plot(plot_of(study, "Error over the setting", {study.parameter, "", Scale::logarithmic, {}, {}},
                      [](const WorkPoint& point) { return point.value; }),
              "A line of slope n is a method of order n.");
    page.table(order_table(study));
  }
  return page;
}

}  // namespace fulcrum::analysis::workprecision
