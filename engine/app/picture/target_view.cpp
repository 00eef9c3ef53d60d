#include "engine/app/picture/target_view.h"

#include <algorithm>

#include "engine/render/frame_data.h"
#include "haptics/math/functions.h"

namespace fulcrum::app {
namespace {

// m, before the eye: what is nearer is nowhere in the picture.
constexpr float kNearest = 0.005F;

// s of the trial in which the touch point is named, at the most.
constexpr double kNamed = 10;

class Projection {
public:
  Projection(const render::Camera& camera, render::Extent picture)
      : clip_from_world_(render::clip_from_world(camera, picture)),
        half_(0.5F * static_cast<float>(picture.width), 0.5F * static_cast<float>(picture.height)),
        px_(half_.y / static_cast<float>(math::tan(0.5 * static_cast<double>(camera.vertical_fov_rad)))) {}

  glm::vec4 clip(const Vec3& p_W) const {
    return clip_from_world_ * glm::vec4(p_W.x(), p_W.y(), p_W.z(), 1.0F);
  }
  static bool is_before(const glm::vec4& clip) { return clip.w >= kNearest; }

  // px, from the picture's middle, times the depth: it has a direction behind the camera, too.
  glm::vec2 offset(const glm::vec4& clip) const { return {clip.x * half_.x, -clip.y * half_.y}; }
  glm::vec2 pixel(const glm::vec4& clip) const { return half_ + offset(clip) / clip.w; }
  // px, of a length in m that is seen from the side.
  float length(float length, const glm::vec4& clip) const { return length * px_ / clip.w; }

  bool holds(const glm::vec2& px) const {
    return px.x >= 0.0F && px.y >= 0.0F && px.x <= 2.0F * half_.x && px.y <= 2.0F * half_.y;
  }
  // px, where a ray from the picture's middle leaves it.
  glm::vec2 edge(const glm::vec2& way) const {
    const glm::vec2 reach = half_ / glm::max(glm::abs(way), glm::vec2(1e-6F));
    return half_ + way * std::min(reach.x, reach.y);
  }

  // The part of it that is before the camera.
  std::optional<ui::Segment> segment(const Vec3& from_W, const Vec3& to_W) const {
    glm::vec4 from = clip(from_W), to = clip(to_W);
    if (!is_before(from) && !is_before(to)) return std::nullopt;
    const auto cut = [](const glm::vec4& before, const glm::vec4& behind) {
      return glm::mix(before, behind, (before.w - kNearest) / (before.w - behind.w));
    };
    if (!is_before(from)) from = cut(to, from);
    if (!is_before(to)) to = cut(from, to);
    return ui::Segment{pixel(from), pixel(to)};
  }

private:
  glm::mat4 clip_from_world_;
  glm::vec2 half_;  // px, half of the picture
  float px_;        // px, of 1 m at 1 m
};

// Straight to the side of what is exactly behind there is none: it is said to be below.
glm::vec2 way_to(const glm::vec2& offset) {
  const float length = glm::length(offset);
  return length > 0.0F ? offset / length : glm::vec2(0.0F, 1.0F);
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
  const glm::vec4 target = projection.clip(next.position), touch = projection.clip(p_WC);
  ui::TargetPlace seen;
  seen.distance = (next.position - p_WC).norm();
  if (Projection::is_before(target)) seen.place = projection.pixel(target);
  seen.in_sight = Projection::is_before(target) && projection.holds(seen.place);
  if (seen.in_sight) {
    seen.radius = projection.length(static_cast<float>(next.radius), target);
  } else {
    seen.way = way_to(projection.offset(target));
    seen.place = projection.edge(seen.way);
  }
  if (Projection::is_before(touch)) seen.touch = projection.pixel(touch);
  const Vec3 foot(p_WC.x(), next.position.y(), p_WC.z());
  seen.drop = projection.segment(p_WC, foot);
  seen.level = projection.segment(foot, next.position);
  return seen;
}

std::optional<ui::Target> target_view(const render::Camera& camera, render::Extent picture,
                                      const TickRecord& record, const scenario::TaskDesc& task,
                                      const scenario::TaskState& state) {
  const std::optional<ui::TargetPlace> at = target_place(camera, picture, record, task, state);
  if (!at) return std::nullopt;
  ui::Target target{.at = *at,
                    .name = task.checkpoints[state.step].name,
                    .dwelling = state.inside,
                    .progress = static_cast<float>(state.dwell_progress),
                    .dwell_s = task.dwell,
                    .touch_name = {}};
  if (state.step == 0 && !state.inside && state.time < kNamed)
    target.touch_name = task.touch_name.empty() ? "the touch point" : task.touch_name;
  return target;
}

}  // namespace fulcrum::app
