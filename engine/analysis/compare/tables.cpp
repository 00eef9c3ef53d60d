#include "engine/analysis/compare/tables.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "haptics/math/functions.h"

namespace fulcrum::analysis::compare {
namespace {

// With so many digits after the point that `shown` has two that count.
std::string to_digits_of(double value, double shown) {
  constexpr int most = 6;
  const int digits = shown > 0 ? 1 - static_cast<int>(std::floor(math::log10(shown))) : most;
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", std::clamp(digits, 0, most), std::abs(value));
  return std::string(value < 0 ? "−" : "").append(text);
}

// The interval by its half: by Student's t it lies evenly about the mean.
std::string text_of(const Estimate& estimate) {
  if (estimate.n == 0) return "—";
  const double half = estimate.interval ? estimate.interval->high - estimate.mean : 0;
  if (half == 0) return report::short_number(estimate.mean, 4) + (estimate.interval ? " ± 0" : "");
  return to_digits_of(estimate.mean, half) + " ± " + to_digits_of(half, half);
}

std::string titled(const MetricName& name) {
  return std::string(name.symbol) + ", " + name.title + " (" + name.unit + ")";
}

}  // namespace

report::Csv compare_csv(const Comparison& comparison) {
  report::Csv csv({"metric", "variant", "n", "mean", "low", "high"});
  for (const Metric metric : kMetrics) {
    for (const VariantRuns& runs : comparison.variants) {
      const Estimate estimate = estimate_of(runs, metric);
      using Cell = report::Csv::Cell;
      const auto given = [](bool there, double value) { return there ? Cell(value) : Cell(""); };
      const Interval interval = estimate.interval.value_or(Interval{});
      csv.row({name_of(metric).csv, runs.name, static_cast<double>(estimate.n),
               given(estimate.n > 0, estimate.mean), given(estimate.interval.has_value(), interval.low),
               given(estimate.interval.has_value(), interval.high)});
    }
  }
  return csv;
}

report::Table compare_table(const Comparison& comparison) {
  report::Table table{{"metric"}, {}};
  for (const VariantRuns& runs : comparison.variants) table.head.push_back(runs.name);
  table.head.push_back("n");
  for (const Metric metric : kMetrics) {
    std::vector<std::string> row{titled(name_of(metric))};
    std::vector<std::string> counts;
    for (const VariantRuns& runs : comparison.variants) {
      const Estimate estimate = estimate_of(runs, metric);
      row.push_back(text_of(estimate));
      counts.push_back(std::to_string(estimate.n));
    }
    const bool alike = std::count(counts.begin(), counts.end(), counts.front()) == std::ssize(counts);
    if (alike) counts.resize(1);
    std::string n;
    for (const std::string& count : counts) n += (n.empty() ? "" : ", ") + count;
    row.push_back(n);
    table.rows.push_back(std::move(row));
  }
  return table;
}

report::Table difference_table(const Comparison& comparison) {
  report::Table table{{"difference", "of", "mean", "n"}, {}};
  const VariantRuns& reference = comparison.variants.front();
  for (const Metric metric : kMetrics) {
    for (std::size_t v = 1; v < comparison.variants.size(); ++v) {
      const Estimate estimate = difference_of(comparison.variants[v], reference, metric);
      table.rows.push_back({comparison.variants[v].name + " − " + reference.name, titled(name_of(metric)),
                            text_of(estimate), std::to_string(estimate.n)});
    }
  }
  return table;
}

}  // namespace fulcrum::analysis::compare
