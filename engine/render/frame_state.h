#pragma once
// What changes from frame to frame. Spans are read during Renderer::frame only.

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "engine/render/visual_desc.h"

namespace fulcrum::render {

class OverlayPass;

struct MarkerState {
  enum class Show { hidden, next, dwelling, done, avoid };
  Show show = Show::hidden;
  float progress = 0.0F;                // 0..1, how much of it is done; read when dwelling
  std::optional<glm::vec3> position{};  // m, in place of the marker's own
};

// Linear, as in the scene target, where 0.6 stands for a radiance of 1.5: brighter would lose its hue in tone
// mapping.
struct MarkerColours {
  glm::vec3 next{0.03F, 0.33F, 0.68F};
  glm::vec3 dwelling{0.70F, 0.34F, 0.01F};
  glm::vec3 done{0.04F, 0.46F, 0.12F};
  glm::vec3 avoid{0.62F, 0.05F, 0.04F};
};

struct GhostState {
  float opacity = 0.0F;               // 0..1; 0: not drawn at all
  glm::mat4 X_WG{1.0F};               // the ghost, a copy of all that follows the tool, to world
  std::optional<glm::vec3> colour{};  // linear; none: the scene's
};

// A second view of the scene, in a part of the picture.
struct Inset {
  Camera camera;
  std::uint32_t x = 0, y = 0;           // pixels, of its top left corner in the picture
  std::uint32_t width = 0, height = 0;  // pixels; all of it is in the picture
};

struct FrameState {
  std::span<const glm::mat4> X_WM;  // one for each movable instance, in the order of VisualDesc::instances
  std::span<const MarkerState> markers;  // one for each VisualDesc::markers; empty: all hidden
  MarkerColours marker_colours;
  std::span<const GhostState> ghosts;  // one for each VisualDesc::ghosts; empty: none is drawn
  Camera camera;
  // Left, right: in stereo, in place of what is made of the camera, where somebody knows them, as a headset
  // does.
  std::optional<std::array<Camera, 2>> eyes{};
  std::optional<Inset> inset{};    // none: nothing is built for it
  double time_s = 0.0;             // simulated time: markers pulse with it, so that a replay looks the same
  OverlayPass* overlay = nullptr;  // drawn last, over the picture; none: nothing
};

}  // namespace fulcrum::render
