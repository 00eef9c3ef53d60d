#include "engine/analysis/uniformity/tables.h"

#include <algorithm>
#include <cmath>

#include "haptics/math/number_text.h"

namespace fulcrum::analysis::uniformity {

report::Csv uniformity_csv(const UniformityStudy& study) {
  report::Csv csv{"method",
                  "place_m",
                  "assigned_stiffness_N_per_m",
                  "felt_stiffness_N_per_m",
                  "felt_torque_error_Nm",
                  "felt_stiffness_scatter_N_per_m",
                  "felt_torque_scatter_Nm",
                  "wanted_torque_Nm"};
  for (const UniformityRow& row : study.rows)
    csv.row({name_of(row.method), row.place, row.stiffness, row.felt_stiffness, row.torque_error,
             row.stiffness_scatter, row.torque_scatter, row.wanted_torque});
  return csv;
}

report::Csv filter_csv(const UniformityStudy& study) {
  report::Csv csv{"filter",         "jerk_m_per_s3_per_rtHz",  "lag_s",          "measured_lag_s",
                  "noise_m_per_s2", "measured_noise_m_per_s2", "error_m_per_s2", "cpu_ns"};
  for (const FilterRow& row : study.filters)
    csv.row({name_of(row.kind), row.jerk, row.lag, row.measured_lag, row.noise, row.measured_noise, row.error,
             row.cpu_ns});
  return csv;
}

double told_torque(double wanted) {
  return std::max(kTorqueJnd * std::abs(wanted), kTorqueLeast);
}

StickSummary summary_of(const UniformityStudy& study, InertiaMethod method, double stiffness) {
  StickSummary summary{.method = method, .stiffness = stiffness};
  int places = 0;
  const UniformityRow* before = nullptr;
  for (const UniformityRow& row : study.rows) {
    if (row.method != method || row.stiffness != stiffness) continue;
    ++places;
    summary.felt += row.felt_stiffness;
    summary.scatter += row.stiffness_scatter;
    summary.worst = std::max(summary.worst, std::abs(row.felt_stiffness / stiffness - 1));
    summary.torque_error = std::max(summary.torque_error, std::abs(row.torque_error));
    summary.torque_over =
        std::max(summary.torque_over, std::abs(row.torque_error) / told_torque(row.wanted_torque));
    if (before && before->place < study.path.held && row.place > study.path.held)
      summary.jump = std::abs(row.torque_error - before->torque_error);
    summary.limited += row.limited;
    before = &row;
  }
  summary.felt /= places;
  summary.scatter /= places;
  return summary;
}

report::Table summary_table(const UniformityStudy& study) {
  report::Table table;
  table.head = {"method",  "assigned, N/m",      "felt, N/m",       "worst of the means",    "scatter, N/m",
                "scatter", "torque error, mN m", "of what is told", "jump at the hand, mN m"};
  for (const InertiaMethod method : kMethods) {
    for (const double stiffness : kStiffnesses) {
      const StickSummary s = summary_of(study, method, stiffness);
      table.rows.push_back({std::string(name_of(method)), number_text(stiffness), number_text(s.felt, 4),
                            number_text(100 * s.worst, 3) + " %", number_text(s.scatter, 3),
                            number_text(100 * s.scatter / stiffness, 2) + " %",
                            number_text(1e3 * s.torque_error, 3), number_text(s.torque_over, 2),
                            number_text(1e3 * s.jump, 3)});
    }
  }
  return table;
}

}  // namespace fulcrum::analysis::uniformity
