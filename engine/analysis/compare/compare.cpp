#include "engine/analysis/compare/compare.h"

#include <algorithm>
#include <cmath>

#include "engine/analysis/compare/student_t.h"

namespace fulcrum::analysis::compare {

MetricName name_of(Metric metric) {
  switch (metric) {
    case Metric::torque_error:
      return {"E_tau", "E_τ", "torque over time", "N m s"};
    case Metric::force_error:
      return {"E_F", "E_F", "force over time", "N s"};
    case Metric::completion_time:
      return {"t_c", "t_c", "completion time", "s"};
  }
  return {};
}

std::optional<double> Trial::value(Metric metric) const {
  if (!fault.empty()) return std::nullopt;  // cut short: its integrals are over less
  switch (metric) {
    case Metric::torque_error:
      return torque_error_Nms;
    case Metric::force_error:
      return force_error_Ns;
    case Metric::completion_time:
      return completion_time_s;
  }
  return std::nullopt;
}

Estimate estimate(std::span<const double> values) {
  Estimate result;
  result.n = values.size();
  if (values.empty()) return result;
  const auto n = static_cast<double>(values.size());
  for (const double value : values) result.mean += value / n;
  if (values.size() < 2) return result;
  double squares = 0;
  for (const double value : values) squares += (value - result.mean) * (value - result.mean);
  const double t = t_quantile(0.5 + 0.5 * kConfidence, static_cast<int>(values.size()) - 1);
  const double half = t * std::sqrt(squares / (n - 1) / n);
  result.interval = {result.mean - half, result.mean + half};
  return result;
}

Estimate estimate_of(const VariantRuns& runs, Metric metric) {
  std::vector<double> values;
  for (const Trial& trial : runs.trials)
    if (const auto value = trial.value(metric)) values.push_back(*value);
  return estimate(values);
}

Estimate difference_of(const VariantRuns& runs, const VariantRuns& reference, Metric metric) {
  std::vector<double> differences;
  for (std::size_t i = 0; i < std::min(runs.trials.size(), reference.trials.size()); ++i) {
    const auto value = runs.trials[i].value(metric), other = reference.trials[i].value(metric);
    if (value && other) differences.push_back(*value - *other);
  }
  return estimate(differences);
}

bool apart(const Estimate& a, const Estimate& b) {
  if (!a.interval || !b.interval) return false;
  return a.interval->high < b.interval->low || b.interval->high < a.interval->low;
}

}  // namespace fulcrum::analysis::compare
