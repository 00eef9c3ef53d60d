#include "engine/session/trial_metrics.h"

#include <cmath>

namespace fulcrum::session {
namespace {

// A figure as results keep it: how it is read, and how it is set.
struct Figure {
  std::string_view name;
  std::optional<double> (*get)(const TrialMetrics&);
  void (*set)(TrialMetrics&, double);
};

template <double TrialMetrics::*member>
constexpr Figure number(std::string_view name) {
  return {name, [](const TrialMetrics& m) { return std::optional(m.*member); },
          [](TrialMetrics& m, double value) { m.*member = value; }};
}

template <std::int64_t TrialMetrics::*member>
constexpr Figure count(std::string_view name) {
  return {name, [](const TrialMetrics& m) { return std::optional(static_cast<double>(m.*member)); },
          [](TrialMetrics& m, double value) { m.*member = std::llround(value); }};
}

template <std::optional<std::int64_t> TrialMetrics::*member>
constexpr Figure count_if_any(std::string_view name) {
  return {name,
          [](const TrialMetrics& m) {
            return m.*member ? std::optional(static_cast<double>(*(m.*member))) : std::nullopt;
          },
          [](TrialMetrics& m, double value) { m.*member = std::llround(value); }};
}

constexpr Figure kFigures[] = {
    number<&TrialMetrics::time>("time_s"),
    {"completed", [](const TrialMetrics& m) { return std::optional(m.completed ? 1.0 : 0.0); },
     [](TrialMetrics& m, double value) { m.completed = value != 0; }},
    count<&TrialMetrics::checkpoints_reached>("checkpoints_reached"),
    count<&TrialMetrics::checkpoints>("checkpoints"),
    number<&TrialMetrics::path>("path_m"),
    {"smoothness", [](const TrialMetrics& m) { return m.smoothness; },
     [](TrialMetrics& m, double value) { m.smoothness = value; }},
    number<&TrialMetrics::contact_time>("contact_s"),
    number<&TrialMetrics::force_mean>("force_mean_N"),
    number<&TrialMetrics::force_95>("force_95_N"),
    number<&TrialMetrics::force_peak>("force_peak_N"),
    number<&TrialMetrics::depth_peak>("depth_peak_m"),
    count<&TrialMetrics::touches_on_the_way>("touches_on_the_way"),
    count_if_any<&TrialMetrics::hard_touches>("hard_touches"),
    number<&TrialMetrics::hard_touch_time>("hard_touch_s"),
    number<&TrialMetrics::torque_error>("torque_error_Nms"),
    number<&TrialMetrics::force_error>("force_error_Ns"),
    count<&TrialMetrics::optional_reached>("optional_reached"),
    count<&TrialMetrics::optional_checkpoints>("optional_checkpoints"),
    count_if_any<&TrialMetrics::slips>("slips"),
    count_if_any<&TrialMetrics::trespasses>("trespasses"),
    number<&TrialMetrics::trespass_time>("trespass_s"),
};

}  // namespace

std::vector<std::pair<std::string, double>> named_values(const TrialMetrics& metrics) {
  std::vector<std::pair<std::string, double>> values;
  for (const Figure& figure : kFigures)
    if (const std::optional<double> value = figure.get(metrics); value && std::isfinite(*value))
      values.emplace_back(figure.name, *value);
  return values;
}

const std::vector<std::string_view>& metric_names() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> all;
    for (const Figure& figure : kFigures) all.push_back(figure.name);
    return all;
  }();
  return names;
}

TrialMetrics from_named_values(const std::vector<std::pair<std::string, double>>& values) {
  constexpr double kMostCounted = 1e15;  // beyond it a count would not be exact
  TrialMetrics metrics;
  for (const auto& [name, value] : values)
    for (const Figure& figure : kFigures)
      if (figure.name == name && std::abs(value) <= kMostCounted) figure.set(metrics, value);
  return metrics;
}

}  // namespace fulcrum::session
