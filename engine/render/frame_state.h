#pragma once
// What changes from frame to frame. Spans are read during Renderer::frame only.

#include <span>

#include "engine/render/visual_desc.h"

namespace fulcrum::render {

class OverlayPass;

struct MarkerState {
  enum class Show { hidden, next, dwelling, done };
  Show show = Show::hidden;
  float progress = 0.0F;  // 0..1, the part of the dwell time that is over; read when dwelling
};

struct GhostState {
  float opacity = 0.0F;  // 0..1; 0: not drawn at all
  glm::mat4 X_WG{1.0F};  // the ghost, a copy of all that follows the tool, to world
};

struct FrameState {
  std::span<const glm::mat4> X_WM;  // one for each movable instance, in the order of VisualDesc::instances
  std::span<const MarkerState> markers;  // one for each VisualDesc::markers; empty: all hidden
  GhostState ghost;
  Camera camera;
  double time_s = 0.0;             // simulated time: markers pulse with it, so that a replay looks the same
  OverlayPass* overlay = nullptr;  // drawn last, over the picture; none: nothing
};

}  // namespace fulcrum::render
