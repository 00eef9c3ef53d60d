#pragma once

#include <string_view>
#include <vector>

#include "engine/analysis/workprecision.h"
#include "engine/report/csv.h"
#include "engine/report/page.h"

namespace fulcrum::analysis {

inline constexpr std::string_view kWorkCsvName = "workprecision.csv", kWorkPageName = "workprecision.html";

// truth, method, parameter, value, error, error_unit, cpu_us, order
report::Csv work_csv(const std::vector<WorkStudy>& studies);
report::Page work_page(const std::vector<WorkStudy>& studies);
// A line a study and method: its finest setting.
report::Table work_table(const std::vector<WorkStudy>& studies);

// The classic voxels' error over the field's at the cost of the field's setting, the smallest over all of
// them; the classic method's own cost is interpolated between its settings. 0: they share no range of cost.
double advantage(const WorkStudy& study);

}  // namespace fulcrum::analysis
