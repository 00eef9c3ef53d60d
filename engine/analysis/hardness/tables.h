#pragma once
// The figures of a hardness study, for a spreadsheet, a page and a terminal.

#include "engine/analysis/hardness/hardness.h"
#include "engine/report/csv.h"
#include "engine/report/page.h"

namespace fulcrum::analysis::hardness {

// device, method, pose, direction, phi_deg, force_N, moment_Nm, felt_force_N, felt_moment_Nm,
// extended_rate_hardness_N_per_m, gamma, delta: a row for each HardnessRow.
report::Csv hardness_csv(const HardnessStudy& study);

// Of the rows at home of a method and an angle: means over directions.
struct MethodSummary {
  PulseMethod method = PulseMethod::none;
  double phi_deg = 0;
  double force = 0, moment = 0;                      // N, N m felt
  double rate_hardness = 0, felt_rate_hardness = 0;  // N/m
  Gain gain;                                         // over force only
  double least_gain = 1, largest_gain = 1;           // of the felt moment
  double helped = 0, lowered = 0;  // part of the directions with more felt moment; with less
};
MethodSummary summary_of(const HardnessStudy& study, PulseMethod method, double phi_deg);

report::Table method_table(const HardnessStudy& study);
report::Table tick_table(const HardnessStudy& study);
// Of very many directions: study.means or study.along_stylus.
report::Table means_table(const std::vector<DirectionMeans>& means);
report::Table angle_table(const HardnessStudy& study);
report::Table axis_table(const HardnessStudy& study);
report::Table cost_table(const HardnessStudy& study);
report::Table shown_table(const HardnessStudy& study);

}  // namespace fulcrum::analysis::hardness
