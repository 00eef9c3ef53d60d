#include "engine/studies/moving_shot.h"

namespace fulcrum::app {
namespace {

constexpr float kStep = 1e-5F;  // m, that the tool moves between frames

}  // namespace

MovingShot::MovingShot(const Shot& shot) : shot_(shot), moved_(shot.X_WM) {
  for (glm::mat4& X : moved_) X[3].y += kStep;
}

render::FrameState MovingShot::next() {
  is_moved_ = !is_moved_;
  render::FrameState state = still();
  if (is_moved_) state.X_WM = moved_;
  return state;
}

render::FrameState MovingShot::still() const {
  render::FrameState state;
  state.camera = shot_.camera;
  state.X_WM = shot_.X_WM;
  return state;
}

void without_marks(render::VisualDesc& desc, const Shot& shot) {
  desc.markers.clear();
  desc.ghosts.clear();
  desc.camera = shot.camera;
}

}  // namespace fulcrum::app
