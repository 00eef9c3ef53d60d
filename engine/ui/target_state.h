#pragma once
// Where the tool has to go next, in the picture. Places are in pixels from its top left, y down.

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

namespace fulcrum::ui {

struct Segment {
  glm::vec2 from{0.0F};  // px
  glm::vec2 to{0.0F};    // px
};

// How much farther from the eye the target's middle is than the touch point; below 0: how much nearer.
struct Farther {
  double depth = 0.0;  // m
  float drag = 0.0F;   // px, of a drag that takes the touch point so deep
};

struct TargetPlace {
  bool in_sight = false;      // its middle is in the picture
  glm::vec2 place{0.0F};      // px, of its middle; out of sight: where at the picture's edge it is nearest
  glm::vec2 way{0.0F, 1.0F};  // unit, out of sight: from the picture's middle to where it would be
  float radius = 0.0F;        // px; 0: out of sight
  double distance = 0.0;      // m, from the touch point to its middle
  std::optional<glm::vec2> touch;  // px, of the touch point; none: behind the camera
  std::optional<Farther> farther;  // none: it is about as far, or one of the two is behind the camera
  // How deep the two are in the scene cannot be seen. From the touch point straight up or down to the
  // target's height, and from there, level, to its middle. None: behind the camera.
  std::optional<Segment> drop, level;
};

// What is out of the picture.
struct EdgePlace {
  glm::vec2 place{0.0F};      // px, at the picture's edge
  glm::vec2 way{0.0F, 1.0F};  // unit, from the picture's middle to where it would be
  std::string name;
};

// Where the tool is touched now.
struct TouchMark {
  glm::vec2 place{0.0F};
  glm::vec2 tip{0.0F};  // the scene's normal there, from the place on: farther, the harder it is pressed
  float load = 0.0F;    // 0..1, the force, of the scene's limit
};

// The scene from somewhere else, in a corner.
struct SecondView {
  std::string name;
  std::vector<TouchMark> touches;  // fractions of its width and height, from its top left
};

struct Target {
  TargetPlace at;
  std::string name;        // of the checkpoint
  bool dwelling = false;   // the touch point is in it
  float progress = 0.0F;   // 0..1, the part of the dwell time that is over
  double dwell_s = 0.0;    // how long to stay
  std::string touch_name;  // beside the touch point; empty: it is not named any more
};

}  // namespace fulcrum::ui
