#include "engine/app/run/expert_run.h"

#include <algorithm>

#include "haptics/math/rotation.h"

namespace fulcrum::app {

namespace {

// Those that were reached, one after the other as they are listed.
bool is_in_order(const std::vector<std::optional<double>>& reached) {
  double before = 0;
  for (const std::optional<double>& time : reached) {
    if (time && *time < before) return false;
    before = time.value_or(before);
  }
  return true;
}

}  // namespace

double same_part(const ExpertRun& expert, const std::vector<std::optional<double>>& reached, double time) {
  const double end = expert.metrics.time;
  if (!is_in_order(reached) || !is_in_order(expert.reached)) return std::min(time, end);
  // A checkpoint before the last that either reached may have been passed: then it parts nothing.
  const auto last = [](const std::vector<std::optional<double>>& list) {
    return std::ranges::find_if(list.rbegin(), list.rend(), [](const auto& each) { return each.has_value(); })
               .base() -
           list.begin();
  };
  double begun = 0, expert_begun = 0;  // s, of this part of the task
  for (std::size_t i = 0; i < std::min(reached.size(), expert.reached.size()); ++i) {
    const auto at = static_cast<std::ptrdiff_t>(i);
    if ((!reached[i] && at < last(reached)) || (!expert.reached[i] && at < last(expert.reached))) continue;
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
