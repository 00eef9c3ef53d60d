#include "engine/app/run/expert_run.h"

#include <algorithm>

#include "haptics/math/rotation.h"

namespace fulcrum::app {

double same_part(const ExpertRun& expert, const std::vector<std::optional<double>>& reached, double time) {
  const double end = expert.metrics.time;
  double begun = 0, expert_begun = 0;  // s, of this part of the task
  for (std::size_t i = 0; i < std::min(reached.size(), expert.reached.size()); ++i) {
    const double expert_done = expert.reached[i].value_or(end);
    if (!reached[i]) return std::min(expert_begun + (time - begun), expert_done);
    if (time < *reached[i]) {
      const double share = (time - begun) / (*reached[i] - begun);
      return expert_begun + share * (expert_done - expert_begun);
    }
    begun = *reached[i];
    expert_begun = expert_done;
  }
  return std::min(expert_begun + (time - begun), end);
}

Pose tool_at(const ExpertRun& expert, double time) {
  using Frame = ToolFilm::Frame;
  const auto after = std::ranges::upper_bound(expert.way, time, {}, &Frame::time);
  if (after == expert.way.begin()) return after->shown;
  const Frame& from = *(after - 1);
  if (after == expert.way.end()) return from.shown;
  const double share = (time - from.time) / (after->time - from.time);
  return {slerp(from.shown.q, after->shown.q, share), from.shown.p + share * (after->shown.p - from.shown.p)};
}

}  // namespace fulcrum::app
