#include "engine/analysis/workprecision/workprecision.h"

#include "haptics/math/functions.h"

namespace fulcrum::analysis::workprecision {

void measure_orders(WorkStudy& study) {
  for (std::size_t i = 1; i < study.points.size(); ++i) {
    const WorkPoint& before = study.points[i - 1];
    WorkPoint& point = study.points[i];
    if (point.method != before.method || !(point.error > 0) || !(before.error > 0)) continue;
    point.order = math::log(before.error / point.error) / math::log(before.value / point.value);
  }
}

std::vector<WorkStudy> study_work_precision(const std::optional<PipingParts>& piping,
                                            const StudyProgress& progress) {
  struct Part {
    const char* what;
    std::function<std::vector<WorkStudy>()> studies;
  };
  const auto one = [](WorkStudy (*study)(bool quick)) {
    return [study] { return std::vector{study(false)}; };
  };
  std::vector<Part> parts{{"A ball's field", one(study_field)},
                          {"A ball in a tube", one(study_tube)},
                          {"A ball on a plane", one(study_sampling)},
                          {"A roller on a knife edge", one(study_rest)},
                          {"A ball pressed into a tube", one(study_press_tube)},
                          {"A ball pressed into a groove", one(study_press_groove)},
                          {"A loaded table", one(study_press_table)},
                          {"Pegs in a hole", [] { return study_pegs(false); }}};
  if (piping) parts.push_back({"The spanner at its nut", [&] { return study_piping(*piping, false); }});
  parts.push_back({"Ticks", one(study_tick)});
  parts.push_back({"An oscillator", one(study_oscillator)});
  parts.push_back({"A top", one(study_tumbling)});
  parts.push_back({"A tone", one(study_tone)});
  parts.push_back({"A trembling hand", one(study_port)});
  std::vector<WorkStudy> studies;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    progress(parts[i].what, static_cast<double>(i) / static_cast<double>(parts.size()));
    for (WorkStudy& study : parts[i].studies()) studies.push_back(std::move(study));
  }
  return studies;
}

}  // namespace fulcrum::analysis::workprecision
