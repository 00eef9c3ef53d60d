#pragma once
// What a stability study leaves behind: stability.csv and stability.html.

#include "engine/analysis/stability/stability.h"
#include "engine/report/csv.h"
#include "engine/report/page.h"

namespace fulcrum::analysis::stability {

inline constexpr std::string_view kStabilityCsvName = "stability.csv", kStabilityPageName = "stability.html";

// device, delay_ticks, B, K_simulated, K_exact, K_passive: a row for each Border.
report::Csv stability_csv(const StabilityStudy& study);

report::Page stability_page(const StabilityStudy& study);

// The figures that tell the most, a row for each device and delay: as in the page.
report::Table z_width_table(const StabilityStudy& study);

}  // namespace fulcrum::analysis::stability
