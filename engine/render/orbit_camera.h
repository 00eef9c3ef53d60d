#pragma once
// A camera that a mouse moves around a point. Knows no window: whoever has one forwards drags and wheel
// turns.

#include "engine/render/visual_desc.h"

namespace fulcrum::render {

class OrbitCamera {
public:
  explicit OrbitCamera(const Camera& start);

  // Turns around the target. Fractions of the window's height; x to the right, y down.
  void orbit(float dx, float dy);
  // Moves target and eye so that the point at the target follows the mouse. Fractions of the window's
  // height.
  void pan(float dx, float dy);
  // Comes closer by one wheel step for +1, keeping between 2 cm and 20 m of the target; in a small or large
  // scene between a quarter and four times of where it started.
  void zoom(float steps);
  // Back to where it started.
  void reset();

  Camera camera() const;

private:
  Camera start_;
  float nearest_m_, farthest_m_;  // to the target
  glm::vec3 target_{0.0F};        // m
  float distance_ = 1.0F;         // m
  float azimuth_rad_ = 0.0F;      // around +Y, 0: the eye is at +Z of the target
  float elevation_rad_ = 0.0F;    // above the horizon
};

}  // namespace fulcrum::render
