#include "engine/analysis/hardness/tables.h"

#include <algorithm>
#include <limits>
#include <numbers>

#include "engine/analysis/hardness/words.h"
#include "haptics/math/functions.h"
#include "haptics/math/number_text.h"

namespace fulcrum::analysis::hardness {
namespace {

std::string direction_text(const Vec3& nhat) {
  return number_text(nhat.x(), 6) + " " + number_text(nhat.y(), 6) + " " + number_text(nhat.z(), 6);
}

std::vector<const HardnessRow*> rows_of(const std::vector<HardnessRow>& rows, PulseMethod method,
                                        double phi_deg) {
  std::vector<const HardnessRow*> found;
  for (const HardnessRow& row : rows)
    if (row.method == method && row.phi_deg == phi_deg && row.pose == kHome) found.push_back(&row);
  return found;
}

}  // namespace

report::Csv hardness_csv(const HardnessStudy& study) {
  report::Csv csv{"device",  "method",    "pose",         "direction",      "phi_deg",
                  "force_N", "moment_Nm", "felt_force_N", "felt_moment_Nm", "extended_rate_hardness_N_per_m",
                  "gamma",   "delta"};
  for (const HardnessRow& row : study.rows)
    csv.row({study.device, name_of(row.method), row.pose, direction_text(row.nhat_D), row.phi_deg,
             row.felt.F_H_D.force.norm(), row.felt.F_H_D.torque.norm(), row.felt.F_H_D.force.norm(),
             row.felt.moment_D.norm(), row.rate_hardness, row.felt.gamma, row.felt.delta()});
  return csv;
}

MethodSummary summary_of(const HardnessStudy& study, PulseMethod method, double phi_deg) {
  const auto rows = rows_of(study.rows, method, phi_deg);
  const auto base = rows_of(study.rows, PulseMethod::force_only, phi_deg);
  MethodSummary summary;
  summary.method = method;
  summary.phi_deg = phi_deg;
  if (rows.empty()) return summary;
  summary.gain = {0, 0};
  summary.least_gain = std::numeric_limits<double>::infinity();
  summary.largest_gain = 0;
  const double part = 1.0 / static_cast<double>(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const HardnessRow& row = *rows[i];
    const Gain gain =
        gain_over(row.felt, base[i]->felt, phi_deg * std::numbers::pi / 180, study.setting.lever);
    summary.force += part * row.felt.force;
    summary.moment += part * row.felt.moment_D.norm();
    summary.rate_hardness += part * row.rate_hardness;
    summary.felt_rate_hardness += part * row.felt_rate_hardness;
    summary.gain.moment += part * gain.moment;
    summary.gain.hardness += part * gain.hardness;
    summary.least_gain = std::min(summary.least_gain, gain.moment);
    summary.largest_gain = std::max(summary.largest_gain, gain.moment);
    if (gain.moment > 1 + kNoticed) summary.helped += part;
    if (gain.moment < 1 - kNoticed) summary.lowered += part;
  }
  return summary;
}

report::Table method_table(const HardnessStudy& study) {
  report::Table table{{"method", "force (N)", "felt moment (N m)", "extended rate-hardness (N/m)",
                       "felt rate-hardness (N/m)", "gain of felt moment", "more moment in", "less in"},
                      {}};
  for (const PulseMethod method : kUsableMethods) {
    const MethodSummary s = summary_of(study, method, kPhi);
    const bool pulse = method != PulseMethod::none, base = method == PulseMethod::force_only;
    table.rows.push_back(
        {title_of(method), number(s.force), number(s.moment), number(s.rate_hardness),
         number(s.felt_rate_hardness),
         !pulse ? ""
         : base ? "1"
                : number(s.gain.moment) + " (" + number(s.least_gain) + " to " + number(s.largest_gain) + ")",
         !pulse || base ? "" : percent(s.helped), !pulse || base ? "" : percent(s.lowered)});
  }
  return table;
}

report::Table tick_table(const HardnessStudy& study) {
  report::Table table{
      {"method", "force (N)", "felt moment (N m)", "gain of felt moment", "gain of contact force", "cut in"},
      {}};
  for (const TickMethod& tick : study.in_the_tick)
    table.rows.push_back({title_of(tick.method), number(tick.force), number(tick.moment),
                          number(tick.gain.moment), number(tick.gain.hardness), percent(tick.cut)});
  return table;
}

report::Table means_table(const std::vector<DirectionMeans>& means) {
  report::Table table{
      {"method", "force (N)", "felt moment (N m)", "gain of felt moment", "largest", "more in", "less in"},
      {}};
  const auto part = [](double value) { return number(100 * value) + " %"; };
  for (const DirectionMeans& m : means) {
    const bool base = m.method == PulseMethod::force_only;
    table.rows.push_back({title_of(m.method), number(m.force), number(m.moment), base ? "1" : number(m.gain),
                          base ? "" : number(m.largest_gain), base ? "" : part(m.helped),
                          base ? "" : part(m.lowered)});
  }
  return table;
}

report::Table angle_table(const HardnessStudy& study) {
  report::Table table{{"φ (°)", "a contact's own moment (N m)", "force only (N m)", "Algorithm 1 (N m)",
                       "exact (N m)", "gain, Algorithm 1", "gain, exact"},
                      {}};
  for (const double phi_deg : kPhis) {
    const MethodSummary force = summary_of(study, PulseMethod::force_only, phi_deg),
                        algorithm1 = summary_of(study, PulseMethod::algorithm1, phi_deg),
                        exact = summary_of(study, PulseMethod::exact, phi_deg);
    table.rows.push_back({number(phi_deg),
                          number(study.setting.lever * study.setting.wanted_force() *
                                 math::sin(phi_deg * std::numbers::pi / 180)),
                          number(force.moment), number(algorithm1.moment), number(exact.moment),
                          number(algorithm1.gain.moment), number(exact.gain.moment)});
  }
  return table;
}

report::Table axis_table(const HardnessStudy& study) {
  report::Table table{{"faces", "φ (°)", "γ", "δ", "m_r, force only (N m)", "m_r, Algorithm 1",
                       "m_r, as printed", "m_r, exact", "f, force only (N)", "f, exact"},
                      {}};
  for (const PaperAxis& axis : study.axes)
    table.rows.push_back({axis.name, number(axis.phi * 180 / std::numbers::pi), number(axis.algorithm1.gamma),
                          number(axis.algorithm1.delta()), number(axis.force_only.moment_D.norm()),
                          number(axis.algorithm1.moment_D.norm()), number(axis.as_printed.moment_D.norm()),
                          number(axis.exact.moment_D.norm()), number(axis.force_only.force),
                          number(axis.exact.force)});
  return table;
}

report::Table cost_table(const HardnessStudy& study) {
  report::Table table{{"method", "missing of the felt wrench, mean", "processor, median (µs)", "99 % (µs)"},
                      {}};
  for (const MethodCost& cost : study.checks.costs)
    table.rows.push_back({title_of(cost.method), number(100 * cost.missing) + " %", number(cost.median_us),
                          number(cost.p99_us)});
  return table;
}

report::Table shown_table(const HardnessStudy& study) {
  report::Table table{{"method", "speed (m/s)", "force (N)", "tilt of the force, mean (°)", "largest (°)",
                       "turn of the moment, mean (°)", "largest of the contact's own moment"},
                      {}};
  const auto deg = [](double rad) { return rad < 1e-6 ? 0.0 : rad * 180 / std::numbers::pi; };
  for (const ShownMethod& s : study.shown)
    table.rows.push_back({title_of(s.method), number(s.speed), number(s.force), number(deg(s.tilt)),
                          number(deg(s.largest_tilt)), number(deg(s.turned)), percent(s.largest_moment)});
  return table;
}

}  // namespace fulcrum::analysis::hardness
