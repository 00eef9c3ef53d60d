#pragma once
// The figures of a comparison, for a spreadsheet, a page and a terminal.

#include "engine/analysis/compare/compare.h"
#include "engine/report/csv.h"

namespace fulcrum::analysis::compare {

// metric, variant, n, mean, low, high: a row for each metric and variant; what there are too few values for
// is left empty.
report::Csv compare_csv(const Comparison& comparison);

// A row for each metric, a column for each variant: the mean and its interval.
report::Table compare_table(const Comparison& comparison);

// A row for each metric and each variant but the first: what it differs by, trial by trial.
report::Table difference_table(const Comparison& comparison);

}  // namespace fulcrum::analysis::compare
