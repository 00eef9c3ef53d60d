#include "engine/analysis/workprecision.h"

#include <cmath>

namespace fulcrum::analysis {

void measure_orders(WorkStudy& study) {
  for (std::size_t i = 1; i < study.points.size(); ++i) {
    const WorkPoint& before = study.points[i - 1];
    WorkPoint& point = study.points[i];
    if (point.method != before.method || !(point.error > 0) || !(before.error > 0)) continue;
    point.order = std::log(before.error / point.error) / std::log(before.value / point.value);
  }
}

std::vector<WorkStudy> study_work_precision(const StudyProgress& progress) {
  struct Part {
    const char* what;
    WorkStudy (*study)(bool quick);
  };
  constexpr Part parts[] = {{"A ball's field", study_field},
                            {"A ball in a tube", study_tube},
                            {"A ball on a plane", study_sampling},
                            {"An oscillator", study_oscillator},
                            {"A top", study_tumbling}};
  std::vector<WorkStudy> studies;
  for (const Part& part : parts) {
    progress(part.what, static_cast<double>(studies.size()) / std::size(parts));
    studies.push_back(part.study(false));
  }
  return studies;
}

}  // namespace fulcrum::analysis
