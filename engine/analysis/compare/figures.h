#pragma once
// The plots of a comparison.

#include "engine/analysis/compare/compare.h"
#include "engine/report/plot.h"

namespace fulcrum::analysis::compare {

// A point for each trial, joined over the variants, and each variant's mean with its interval.
report::Plot metric_plot(const Comparison& comparison, Metric metric);

// |tau_v| of the first trial of a variant over time: where it was bad, and the cues above it.
report::Plot course_plot(const Comparison& comparison, std::size_t variant);

}  // namespace fulcrum::analysis::compare
