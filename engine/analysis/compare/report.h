#pragma once
// What a comparison leaves behind: compare.csv, compare.json and compare.html.

#include "engine/analysis/compare/compare.h"
#include "engine/report/page.h"

namespace fulcrum::analysis::compare {

inline constexpr std::string_view kCompareCsvName = "compare.csv", kCompareJsonName = "compare.json",
                                  kComparePageName = "compare.html";

report::Page compare_page(const Comparison& comparison);

// What the numbers are of, and what they are not.
const char* reservation(const Comparison& comparison);

}  // namespace fulcrum::analysis::compare
