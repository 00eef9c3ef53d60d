#pragma once
// The gamepads that Linux shows and that no driver here is for: an Xbox pad and all that is built like one.
//
// Source: Documentation/input/gamepad.rst of Linux, which says what BTN_GAMEPAD promises and where each
// control is.

#include <cstdint>
#include <string>
#include <vector>

namespace fulcrum {

struct GamepadPlace {
  std::string node;  // "/dev/input/event7"
  std::string name;
  bool permitted = false;  // its node may be opened by you
  // What its controls are, as GLFW takes it (and SDL), for a pad that GLFW does not know.
  std::string mapping;
};

std::vector<GamepadPlace> find_gamepads();

// Empty: one is there and may be opened.
std::string why_no_gamepad();

}  // namespace fulcrum
