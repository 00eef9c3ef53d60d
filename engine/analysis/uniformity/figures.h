#pragma once
// The plots of a uniformity study.

#include "engine/analysis/uniformity/uniformity.h"
#include "engine/report/panels.h"
#include "engine/report/plot.h"

namespace fulcrum::analysis::uniformity {

report::Plot stiffness_plot(const UniformityStudy& study);  // felt over assigned, against assigned
report::Plot torque_plot(const UniformityStudy& study, double stiffness);  // at the hand, along the stick
report::Panels torque_panels(const UniformityStudy& study);                // its error, everywhere
report::Plot lag_plot(const UniformityStudy& study);                       // of the filters, against noise
report::Plot cost_plot(const UniformityStudy& study);                      // their error against run time
report::Plot limit_plot(const UniformityStudy& study);                     // of lag, against the gain
report::Plot mass_plot(const UniformityStudy& study);                      // of lag, against the hand's mass
report::Plot late_plot(const UniformityStudy& study);                      // the handle's way, late

}  // namespace fulcrum::analysis::uniformity
