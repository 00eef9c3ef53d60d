#pragma once
// Where a window's pointer is in the picture that either eye has of the window: where both halves show the
// whole of it, squeezed, the pointer is in one of them.

#include <glm/glm.hpp>
#include <optional>

#include "engine/render/stereo.h"

namespace fulcrum::app {

class EyePointer {
public:
  // (2) heights of the picture: to the right, down.
  struct Move {
    glm::dvec2 to{};  // from its top left
    glm::dvec2 by{};
  };

  // mode: none for one eye. aspect: the window's width by its height. at: (2) heights of the window, from its
  // top left. held: a button is down, and the pointer stays in the half where it is, beyond its edges, too.
  Move move(const std::optional<render::StereoMode>& mode, double aspect, const glm::dvec2& at, bool held);

private:
  glm::dvec2 last_{};    // heights of the window
  bool second_ = false;  // half, in which it is
};

}  // namespace fulcrum::app
