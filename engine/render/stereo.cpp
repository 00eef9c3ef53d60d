#include "engine/render/stereo.h"

#include <algorithm>
#include <cmath>

#include "engine/render/frame_data.h"

namespace fulcrum::render {
namespace {

// Of the window's height, between eyes that nobody has given a distance: what is infinitely far, and what is
// half as far as the window, is then a fiftieth of a picture of 16:9 apart, a good degree on a desk.
constexpr float kEyesApart = 0.0356F;

float window_height(const Camera& camera) {
  return 2.0F * convergence_of(camera) * std::tan(0.5F * camera.vertical_fov_rad);
}

}  // namespace

float convergence_of(const Camera& camera) {
  return camera.eyes.convergence.value_or(glm::length(camera.target - camera.eye));
}

float eye_distance_of(const Camera& camera) {
  return camera.eyes.distance.value_or(kEyesApart * window_height(camera));
}

Camera seen_by(Eye eye, const Stereo& stereo, const Camera& camera) {
  const float side = eye == Eye::left ? -0.5F : eye == Eye::right ? 0.5F : 0.0F;
  const float convergence = convergence_of(camera);
  // (3) m in the scene, from the window's middle: right, up and before it.
  glm::vec3 at(side * eye_distance_of(camera), 0.0F, convergence);
  Camera seen = camera;
  if (stereo.screen) {
    const Screen& screen = *stereo.screen;
    const float height = window_height(camera);
    at = (screen.head + glm::vec3(side * screen.eye_distance, 0.0F, 0.0F)) * (height / screen.height);
    seen.vertical_fov_rad = 2.0F * std::atan(0.5F * height / at.z);
  }
  const glm::mat3 world_from_view = glm::transpose(glm::mat3(view_of(camera)));
  const glm::vec3 moved = world_from_view * glm::vec3(at.x, at.y, at.z - convergence);
  const glm::vec3 ahead = camera.target - camera.eye;
  seen.eye += moved;
  // As far ahead as the eye has gone: nearer to it, a float would not hold the direction.
  seen.target = seen.eye + ahead * std::max(1.0F, glm::length(moved) / glm::length(ahead));
  seen.lean = glm::vec2(-at.x, -at.y) / at.z;
  return seen;
}

}  // namespace fulcrum::render
