#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/analysis/workprecision/workprecision.h"
#include "engine/report/csv.h"
#include "engine/report/page.h"

namespace fulcrum::analysis::workprecision {

inline constexpr std::string_view kWorkCsvName = "workprecision.csv", kWorkPageName = "workprecision.html";

// truth, method, parameter, value, error, error_unit, cpu_us, order
report::Csv work_csv(const std::vector<WorkStudy>& studies);
report::Page work_page(const std::vector<WorkStudy>& studies);
// A line a study and method: its finest setting.
report::Table work_table(const std::vector<WorkStudy>& studies);

// How many times smaller the error of `method` is than that of the study's baseline: for each setting of the
// baseline, against the best that the method does for that cost or less; the smallest over all of them. 0:
// nothing of the method is as cheap.
double advantage(const WorkStudy& study, const std::string& method);

// The methods of each study with a baseline, and whether they keep kGoal.
inline constexpr double kGoal = 20;
report::Table advantage_table(const std::vector<WorkStudy>& studies);
std::string goal_sentence(const std::vector<WorkStudy>& studies);

}  // namespace fulcrum::analysis::workprecision
