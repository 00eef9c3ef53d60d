#pragma once
// A shot in which the tool moves a little from frame to frame.

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
  // The moment itself.
  render::FrameState still() const;

private:
  const Shot& shot_;
  std::vector<glm::mat4> moved_;
  bool is_moved_ = false;
};

// The scene alone, from where the shot is taken.
void without_marks(render::VisualDesc& desc, const Shot& shot);

}  // namespace fulcrum::app
