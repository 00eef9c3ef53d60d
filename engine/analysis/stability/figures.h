#pragma once
// The plots of a stability study.

#include "engine/analysis/stability/stability.h"
#include "engine/report/plot.h"

namespace fulcrum::analysis::stability {

report::Plot plane_plot(const StabilityStudy& study);  // growth rates and borders about the origin
report::Plot border_plot(const StabilityStudy& study, const std::string& device);  // each delay, all damping
report::Plot tick_plot(const StabilityStudy& study);
report::Plot energy_plot(const StabilityStudy& study);
report::Plot speed_plot(const StabilityStudy& study, std::size_t device);
report::Plot diolaiti_plot(const StabilityStudy& study);

}  // namespace fulcrum::analysis::stability
