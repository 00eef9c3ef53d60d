#include "engine/render/orbit_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fulcrum::render {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kSteepest_rad = 1.54F;  // straight down has no up

}  // namespace

OrbitCamera::OrbitCamera(const Camera& start)
    : start_(start),
      nearest_m_(std::min(0.02F, 0.25F * glm::length(start.eye - start.target))),
      farthest_m_(std::max(20.0F, 4.0F * glm::length(start.eye - start.target))) {
  reset();
}

void OrbitCamera::reset() {
  const glm::vec3 offset = start_.eye - start_.target;
  target_ = start_.target;
  distance_ = std::max(glm::length(offset), 1e-6F);
  azimuth_rad_ = std::atan2(offset.x, offset.z);
  elevation_rad_ =
      std::clamp(std::asin(std::clamp(offset.y / distance_, -1.0F, 1.0F)), -kSteepest_rad, kSteepest_rad);
}

void OrbitCamera::orbit(float dx, float dy) {
  azimuth_rad_ = std::remainder(azimuth_rad_ - dx * kPi, 2.0F * kPi);  // a window's height is half a turn
  elevation_rad_ = std::clamp(elevation_rad_ + dy * kPi, -kSteepest_rad, kSteepest_rad);
}

void OrbitCamera::pan(float dx, float dy) {
  const Camera now = camera();
  const glm::vec3 forward = glm::normalize(now.target - now.eye);
  const glm::vec3 right = glm::normalize(glm::cross(forward, glm::vec3(0.0F, 1.0F, 0.0F)));
  const glm::vec3 up = glm::cross(right, forward);
  const float height =
      2.0F * distance_ * std::tan(0.5F * start_.vertical_fov_rad);  // of the view, at the target
  target_ += height * (dy * up - dx * right);
}

void OrbitCamera::zoom(float steps) {
  distance_ = std::clamp(distance_ * std::pow(0.9F, steps), nearest_m_, farthest_m_);
}

Camera OrbitCamera::camera() const {
  const glm::vec3 direction{std::cos(elevation_rad_) * std::sin(azimuth_rad_), std::sin(elevation_rad_),
                            std::cos(elevation_rad_) * std::cos(azimuth_rad_)};
  Camera now = start_;
  now.eye = target_ + distance_ * direction;
  now.target = target_;
  return now;
}

}  // namespace fulcrum::render
