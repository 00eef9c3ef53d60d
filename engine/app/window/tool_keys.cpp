#include "engine/app/window/tool_keys.h"

#include <GLFW/glfw3.h>

#include <algorithm>

namespace fulcrum::app {
namespace {

// The one that pushes an axis to -1, and the one that pushes it to 1: way right, up, toward the person; turn
// about these.
constexpr int kPushes[] = {
    GLFW_KEY_LEFT, GLFW_KEY_RIGHT, GLFW_KEY_DOWN, GLFW_KEY_UP, GLFW_KEY_PAGE_UP, GLFW_KEY_PAGE_DOWN,
    GLFW_KEY_W,    GLFW_KEY_S,     GLFW_KEY_D,    GLFW_KEY_A,  GLFW_KEY_E,       GLFW_KEY_Q,
};

// A key is pushed or not. The speed is the square of these.
constexpr double kPush = 0.6, kFine = 0.2;

}  // namespace

bool ToolKeys::note(int key, int action) {
  const auto at = std::ranges::find(kPushes, key);
  if (at == std::end(kPushes)) return false;
  down_[static_cast<std::size_t>(at - std::begin(kPushes))] = action != GLFW_RELEASE;
  return true;
}

PushedAxes ToolKeys::axes(bool fine) const {
  const double push = fine ? kFine : kPush;
  const auto pushed = [&](std::size_t axis) {
    return push * ((down_[2 * axis + 1] ? 1.0 : 0.0) - (down_[2 * axis] ? 1.0 : 0.0));
  };
  return {.way = {pushed(0), pushed(1), pushed(2)}, .turn = {pushed(3), pushed(4), pushed(5)}};
}

std::vector<std::string> ToolKeys::help() {
  return {"Arrows: tool left, right, up, down", "Page up, page down: away and nearer",
          "W, S: tool tilts away and back",     "A, D: tool turns left and right",
          "Q, E: tool rolls left and right",    "Shift: the same, nine times slower"};
}

}  // namespace fulcrum::app
