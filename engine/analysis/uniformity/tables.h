#pragma once
// A uniformity study in numbers: its tables as files, and means over the stick.

#include "engine/analysis/uniformity/uniformity.h"
#include "engine/report/csv.h"
#include "engine/report/page.h"

namespace fulcrum::analysis::uniformity {

report::Csv uniformity_csv(const UniformityStudy& study);
report::Csv filter_csv(const UniformityStudy& study);

// Of a method and a stiffness, along the whole stick.
struct StickSummary {
  InertiaMethod method = InertiaMethod::none;
  double stiffness = 0;     // N/m, assigned
  double felt = 0;          // N/m, mean
  double worst = 0;         // of the means along the stick, the largest |felt - assigned| over assigned
  double scatter = 0;       // N/m, from strike to strike, mean
  double torque_error = 0;  // N m, largest of the means along the stick
  double torque_over = 0;   // the same over what is told apart there, see told_torque()
  double jump = 0;          // N m, of the torque error from one side of the hand to the other
  int limited = 0;          // strikes
};
StickSummary summary_of(const UniformityStudy& study, InertiaMethod method, double stiffness);

// N m, the least error of that torque that a person might tell.
double told_torque(double wanted);

// A row for each method and stiffness.
report::Table summary_table(const UniformityStudy& study);

}  // namespace fulcrum::analysis::uniformity
