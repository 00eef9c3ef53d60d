#pragma once
// A shot in which the tool moves a little from frame to frame, and how long frames take.

#include <array>
#include <cstddef>
#include <vector>

#include "engine/render/frame_state.h"
#include "engine/studies/picture_shot.h"

namespace fulcrum::app {

// Shadows of what moves are drawn anew in each of its frames; every other one shows the moment itself, the
// first does not.
class MovingShot {
public:
  // The shot must outlive it.
  explicit MovingShot(const Shot& shot);

  // Valid until the next.
  render::FrameState next();

private:
  const Shot& shot_;
  std::vector<glm::mat4> moved_;
  bool is_moved_ = false;
};

// The median of some, after the first ones: drivers compile shaders while drawing those.
class FrameTimes {
public:
  static constexpr std::size_t kUncounted = 3, kFrames = 9;

  void add(double frame_s);
  // Of all of them.
  double median_ms() const;

private:
  std::array<double, kUncounted + kFrames> times_{};
  std::size_t count_ = 0;
};

// The scene alone, from where the shot is taken.
void without_marks(render::VisualDesc& desc, const Shot& shot);

}  // namespace fulcrum::app
