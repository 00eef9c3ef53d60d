#include "engine/app/picture/second_view.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>

#include "engine/app/picture/projection.h"
#include "engine/app/window/key_help.h"

namespace fulcrum::app {
namespace {

constexpr float kSquareEnough = 0.7071F;  // cosine
constexpr std::size_t kMostMarks = 8;
constexpr float kShortest = 0.02F,
                kLongest = 0.10F;  // of the picture's height: an arrow of no load, of limit

glm::vec3 direction(const render::Camera& camera) {
  return glm::normalize(camera.target - camera.eye);
}

// A quarter turn about the vertical through what it looks at. From straight above, where that turns nothing
// but the picture, from the front.
render::Camera from_the_side(const render::Camera& from) {
  render::Camera side = from;
  const glm::vec3 away = from.eye - from.target;
  const glm::vec3 level(away.x, 0.0F, away.z);
  const float distance = glm::length(away);
  side.eye = glm::length(level) > 0.2F * distance ? from.target + glm::vec3(away.z, away.y, -away.x)
                                                  : from.target + glm::vec3(0.0F, 0.2F, 1.0F) * distance;
  return side;
}

}  // namespace

ChosenView second_view(const render::Camera& from, std::span<const scenario::View> views) {
  const auto parallel = [&](const scenario::View& view) {
    return std::abs(glm::dot(direction(view.camera), direction(from)));
  };
  const auto best = std::ranges::min_element(views, {}, parallel);
  if (best != views.end() && parallel(*best) <= kSquareEnough) return {view_name(*best), best->camera};
  return {"from the side", from_the_side(from)};
}

std::vector<ui::TouchMark> touch_marks(const render::Camera& camera, render::Extent picture,
                                       std::span<const Touch> touches, double limit) {
  const Projection projection(camera, picture);
  std::vector<ui::TouchMark> marks;
  for (const Touch& touch : touches.first(std::min(touches.size(), kMostMarks))) {
    const glm::vec4 place = projection.clip(touch.p_W);
    if (!projection.is_before(place)) continue;
    const double load = limit > 0 ? std::min(touch.force / limit, 1.0) : 0.0;
    // So long in the scene that, seen from the side, it is that part of the picture.
    const float part = kShortest + (kLongest - kShortest) * static_cast<float>(load);
    const double length =
        static_cast<double>(part * static_cast<float>(picture.height) / projection.length(1.0F, place));
    const glm::vec4 tip = projection.clip(touch.p_W + length * touch.nhat_W);
    if (!projection.is_before(tip)) continue;
    marks.push_back({projection.pixel(place), projection.pixel(tip), static_cast<float>(load)});
  }
  return marks;
}

std::vector<ui::TouchMark> in_fractions(std::vector<ui::TouchMark> marks, render::Extent picture) {
  const glm::vec2 size(static_cast<float>(picture.width), static_cast<float>(picture.height));
  for (ui::TouchMark& mark : marks) {
    mark.place /= size;
    mark.tip /= size;
  }
  return marks;
}

}  // namespace fulcrum::app
