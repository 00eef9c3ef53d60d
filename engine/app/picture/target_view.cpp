#include "engine/app/picture/target_view.h"

#include <algorithm>
#include <cmath>

#include "engine/app/picture/projection.h"
#include "engine/scenario/hint.h"

namespace fulcrum::app {
namespace {

// Of a checkpoint's radius: what is not deeper in it or before it is as far away as its middle.
constexpr double kAsFar = 0.5;

// s of the trial in which the touch point is named, at the most.
constexpr double kNamed = 10;

// How much farther the target is, where that matters to somebody who has to hit its radius.
std::optional<ui::Farther> farther(const Projection& projection, const glm::vec4& touch,
                                   const glm::vec4& target, double radius) {
  if (!projection.is_before(touch) || !projection.is_before(target)) return std::nullopt;
  const float depth = target.w - touch.w;
  if (static_cast<double>(std::abs(depth)) <= kAsFar * radius) return std::nullopt;
  return ui::Farther{depth, projection.length(depth, touch)};
}

// What a checkpoint needs beside, in a word or two.
std::string lacking_words(scenario::Lack lack) {
  switch (lack) {
    case scenario::Lack::nothing:
      return {};
    case scenario::Lack::touch:
      return "touch it";
    case scenario::Lack::stop:
      return "stop the force here";
    case scenario::Lack::more_force:
      return "press harder";
    case scenario::Lack::less_force:
      return "press less hard";
    case scenario::Lack::facing:
      return "turn the tool";
    case scenario::Lack::less_depth:
      return "too deep";
  }
  return {};
}

}  // namespace

std::optional<ui::TargetPlace> target_place(const render::Camera& camera, render::Extent picture,
                                            const TickRecord& record, const scenario::TaskDesc& task,
                                            const scenario::TaskState& state) {
  if (state.step >= task.checkpoints.size()) return std::nullopt;
  const Vec3 p_WC = record.X_WT * task.touch_point;
  if (!p_WC.allFinite()) return std::nullopt;
  const scenario::Checkpoint& next = task.checkpoints[state.step];
  const Projection projection(camera, picture);
  const glm::vec4 target = projection.clip(state.place_W), touch = projection.clip(p_WC);
  ui::TargetPlace seen;
  seen.distance = (state.place_W - p_WC).norm();
  if (projection.is_before(target)) seen.place = projection.pixel(target);
  seen.in_sight = projection.is_before(target) && projection.holds(seen.place);
  if (seen.in_sight) {
    seen.radius = projection.length(static_cast<float>(next.radius), target);
  } else {
    seen.way = projection.way_to(target);
    seen.place = projection.edge(seen.way);
  }
  if (projection.is_before(touch)) seen.touch = projection.pixel(touch);
  seen.farther = farther(projection, touch, target, next.radius);
  const Vec3 foot(p_WC.x(), state.place_W.y(), p_WC.z());
  seen.drop = projection.segment(p_WC, foot);
  seen.level = projection.segment(foot, state.place_W);
  return seen;
}

std::optional<ui::EdgePlace> lost_tool(const render::Camera& camera, render::Extent picture,
                                       const TickRecord& record, const scenario::TaskDesc& task) {
  const Vec3 p_WC = record.X_WT * task.touch_point;
  if (!p_WC.allFinite()) return std::nullopt;
  const Projection projection(camera, picture);
  const glm::vec4 tool = projection.clip(p_WC);
  if (projection.is_before(tool) && projection.holds(projection.pixel(tool))) return std::nullopt;
  const glm::vec2 way = projection.way_to(tool);
  return ui::EdgePlace{projection.edge(way), way, task.touch_name.empty() ? "the tool" : task.touch_name};
}

std::optional<ui::Target> target_view(const render::Camera& camera, render::Extent picture,
                                      const TickRecord& record, const scenario::TaskDesc& task,
                                      const scenario::TaskState& state) {
  const std::optional<ui::TargetPlace> at = target_place(camera, picture, record, task, state);
  if (!at) return std::nullopt;
  const scenario::Checkpoint& next = task.checkpoints[state.step];
  ui::Target target{.at = *at,
                    .name = state.lack != scenario::Lack::nothing ? lacking_words(state.lack) : next.name,
                    .dwelling = state.inside,
                    .progress = static_cast<float>(shown_progress(state)),
                    .dwell_s = dwell_of(task, next),
                    .touch_name = {}};
  if (reached_count(state) == 0 && !state.inside && state.time < kNamed)
    target.touch_name = task.touch_name.empty() ? "the touch point" : task.touch_name;
  return target;
}

std::string advice(const scenario::TaskDesc& task, const scenario::TaskState& state,
                   const DeviceWords& words) {
  if (state.step >= task.checkpoints.size()) return {};
  const auto& [move, turn, finely, stop, go_on] = words;
  return scenario::hint_text(task.checkpoints[state.step].hint, {move, turn, finely, stop, go_on});
}

}  // namespace fulcrum::app
