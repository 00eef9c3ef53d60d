#pragma once
// What a uniformity study leaves behind: uniformity.csv, filter.csv and uniformity.html.

#include "engine/analysis/uniformity/uniformity.h"
#include "engine/report/page.h"

namespace fulcrum::analysis::uniformity {

inline constexpr std::string_view kUniformityCsvName = "uniformity.csv", kFilterCsvName = "filter.csv",
                                  kUniformityPageName = "uniformity.html";

report::Page uniformity_page(const UniformityStudy& study);

// What came of it, as sentences.
std::vector<std::string> uniformity_answer(const UniformityStudy& study);

}  // namespace fulcrum::analysis::uniformity
