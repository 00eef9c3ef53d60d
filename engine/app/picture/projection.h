#pragma once
// Where in a picture a camera sees a place of the scene. Pixels from the top left, y down.

#include <algorithm>
#include <glm/glm.hpp>
#include <optional>

#include "engine/render/frame_data.h"
#include "engine/ui/target_state.h"
#include "haptics/math/functions.h"
#include "haptics/math/linear.h"

namespace fulcrum::app {

class Projection {
public:
  Projection(const render::Camera& camera, render::Extent picture)
      : clip_from_world_(render::clip_from_world(camera, picture)),
        nearest_(render::nearest_seen(camera)),
        half_(0.5F * static_cast<float>(picture.width), 0.5F * static_cast<float>(picture.height)),
        px_(half_.y / static_cast<float>(math::tan(0.5 * static_cast<double>(camera.vertical_fov_rad)))) {}

  glm::vec4 clip(const Vec3& p_W) const {
    return clip_from_world_ * glm::vec4(p_W.x(), p_W.y(), p_W.z(), 1.0F);
  }
  bool is_before(const glm::vec4& clip) const { return clip.w >= nearest_; }

  // px, from the picture's middle, times the depth: it has a direction behind the camera, too.
  glm::vec2 offset(const glm::vec4& clip) const { return {clip.x * half_.x, -clip.y * half_.y}; }
  glm::vec2 pixel(const glm::vec4& clip) const { return half_ + offset(clip) / clip.w; }
  // px, of a length in m that is seen from the side.
  float length(float length, const glm::vec4& clip) const { return length * px_ / clip.w; }

  bool holds(const glm::vec2& px) const {
    return px.x >= 0.0F && px.y >= 0.0F && px.x <= 2.0F * half_.x && px.y <= 2.0F * half_.y;
  }
  // Unit, from the picture's middle to where it would be. Straight behind there is no such way: it is said to
  // be below.
  glm::vec2 way_to(const glm::vec4& clip) const {
    const glm::vec2 away = offset(clip);
    const float length = glm::length(away);
    return length > 0.0F ? away / length : glm::vec2(0.0F, 1.0F);
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
    const auto cut = [this](const glm::vec4& before, const glm::vec4& behind) {
      return glm::mix(before, behind, (before.w - nearest_) / (before.w - behind.w));
    };
    if (!is_before(from)) from = cut(to, from);
    if (!is_before(to)) to = cut(from, to);
    return ui::Segment{pixel(from), pixel(to)};
  }

private:
  glm::mat4 clip_from_world_;
  float nearest_;   // m, before the eye: what is nearer is nowhere in the picture
  glm::vec2 half_;  // px, half of the picture
  float px_;        // px, of 1 m at 1 m
};

}  // namespace fulcrum::app
