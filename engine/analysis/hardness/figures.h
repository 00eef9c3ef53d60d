#pragma once
// The plots of a hardness study.

#include "engine/analysis/hardness/hardness.h"
#include "engine/report/panels.h"

namespace fulcrum::analysis::hardness {

report::Panels sky_panels(const HardnessStudy& study, double Gain::*gain);  // over directions, by angle
report::Panels pose_panels(const HardnessStudy& study);                     // over the workspace
report::Plot moment_plot(const HardnessStudy& study);                       // felt, over the angle
report::Plot speed_plot(const HardnessStudy& study);  // gain in felt hardness, over the angle and speed
report::Plot lean_plot(const HardnessStudy& study);
report::Plot front_plot(const HardnessStudy& study);
report::Plot cost_plot(const HardnessStudy& study);

}  // namespace fulcrum::analysis::hardness
