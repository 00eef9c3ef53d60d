#pragma once
// What a hardness study leaves behind: hardness.csv, hardness.json and hardness.html.

#include "engine/analysis/hardness/hardness.h"
#include "engine/report/page.h"

namespace fulcrum::analysis::hardness {

inline constexpr std::string_view kHardnessCsvName = "hardness.csv", kHardnessJsonName = "hardness.json",
                                  kHardnessPageName = "hardness.html";
inline constexpr double kBudget_us = 20;  // of a tick's allocation, 99 % of all

report::Page hardness_page(const HardnessStudy& study);

// What came of it, as sentences: where a moment helps on this device.
std::vector<std::string> hardness_answer(const HardnessStudy& study);

}  // namespace fulcrum::analysis::hardness
