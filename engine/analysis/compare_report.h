#pragma once
// What a comparison leaves behind: compare.csv, compare.json and compare.html.

#include "engine/analysis/compare.h"
#include "engine/report/csv.h"
#include "engine/report/page.h"

namespace fulcrum::analysis {

inline constexpr std::string_view kCompareCsvName = "compare.csv", kCompareJsonName = "compare.json",
                                  kComparePageName = "compare.html";

// metric, variant, n, mean, low, high: a row for each metric and variant; what there are too few values for
// is left empty.
report::Csv compare_csv(const Comparison& comparison);

report::Page compare_page(const Comparison& comparison);

// A row for each metric, a column for each variant: the mean and its interval.
report::Table compare_table(const Comparison& comparison);

// A row for each metric and each variant but the first: what it differs by, trial by trial.
report::Table difference_table(const Comparison& comparison);

// What the numbers are of, and what they are not.
const char* reservation(const Comparison& comparison);

}  // namespace fulcrum::analysis
