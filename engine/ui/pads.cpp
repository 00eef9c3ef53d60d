#include "engine/ui/pads.h"

#include <GLFW/glfw3.h>

#include <cstdlib>

namespace fulcrum::ui {
namespace {

constexpr double kTilted = 0.6;  // of a stick's way, that means it

// Which of GLFW's buttons is which bit.
struct Button {
  int glfw;
  std::uint32_t bit;
};
constexpr Button kButtons[] = {
    {GLFW_GAMEPAD_BUTTON_A, kPadA},
    {GLFW_GAMEPAD_BUTTON_B, kPadB},
    {GLFW_GAMEPAD_BUTTON_X, kPadX},
    {GLFW_GAMEPAD_BUTTON_Y, kPadY},
    {GLFW_GAMEPAD_BUTTON_LEFT_BUMPER, kPadLeftBumper},
    {GLFW_GAMEPAD_BUTTON_RIGHT_BUMPER, kPadRightBumper},
    {GLFW_GAMEPAD_BUTTON_BACK, kPadBack},
    {GLFW_GAMEPAD_BUTTON_START, kPadStart},
    {GLFW_GAMEPAD_BUTTON_DPAD_UP, kPadUp},
    {GLFW_GAMEPAD_BUTTON_DPAD_RIGHT, kPadRight},
    {GLFW_GAMEPAD_BUTTON_DPAD_DOWN, kPadDown},
    {GLFW_GAMEPAD_BUTTON_DPAD_LEFT, kPadLeft},
};

// Of a GUID's four digits from there on, the lower byte first; 0 where they are none.
std::uint16_t number_in(const std::string& guid, std::size_t from) {
  if (guid.size() < from + 4) return 0;
  const std::string digits = guid.substr(from + 2, 2) + guid.substr(from, 2);
  return static_cast<std::uint16_t>(std::strtoul(digits.c_str(), nullptr, 16));
}

PadState state_of(const char* guid, const GLFWgamepadstate& now) {
  PadState pad;
  pad.guid = guid;
  pad.vendor = number_in(pad.guid, 8);
  pad.product = number_in(pad.guid, 16);
  // GLFW counts sticks downwards, and triggers from -1.
  const auto axis = [&](int of) { return static_cast<double>(now.axes[of]); };
  pad.left_x = axis(GLFW_GAMEPAD_AXIS_LEFT_X);
  pad.left_y = -axis(GLFW_GAMEPAD_AXIS_LEFT_Y);
  pad.right_x = axis(GLFW_GAMEPAD_AXIS_RIGHT_X);
  pad.right_y = -axis(GLFW_GAMEPAD_AXIS_RIGHT_Y);
  pad.left_trigger = (axis(GLFW_GAMEPAD_AXIS_LEFT_TRIGGER) + 1) / 2;
  pad.right_trigger = (axis(GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER) + 1) / 2;
  for (const Button& button : kButtons)
    if (now.buttons[button.glfw] == GLFW_PRESS) pad.buttons |= button.bit;
  return pad;
}

}  // namespace

std::vector<PadState> pad_states() {
  std::vector<PadState> pads;
  for (int joystick = GLFW_JOYSTICK_1; joystick <= GLFW_JOYSTICK_LAST; ++joystick) {
    GLFWgamepadstate now;
    if (glfwGetGamepadState(joystick, &now) != GLFW_TRUE) continue;
    if (const char* const guid = glfwGetJoystickGUID(joystick)) pads.push_back(state_of(guid, now));
  }
  return pads;
}

std::uint32_t menu_buttons(std::span<const PadState> pads) {
  std::uint32_t down = 0;
  for (const PadState& pad : pads) {
    down |= pad.buttons;
    if (pad.left_y > kTilted) down |= kPadUp;
    if (pad.left_y < -kTilted) down |= kPadDown;
    if (pad.left_x > kTilted) down |= kPadRight;
    if (pad.left_x < -kTilted) down |= kPadLeft;
  }
  return down;
}

void learn_pads(std::span<const std::string> mappings) {
  for (int joystick = GLFW_JOYSTICK_1; joystick <= GLFW_JOYSTICK_LAST; ++joystick) {
    if (glfwJoystickPresent(joystick) != GLFW_TRUE || glfwJoystickIsGamepad(joystick) == GLFW_TRUE) continue;
    const char* const guid = glfwGetJoystickGUID(joystick);
    if (guid == nullptr) continue;
    for (const std::string& mapping : mappings)
      if (mapping.starts_with(guid)) glfwUpdateGamepadMappings(mapping.c_str());
  }
}

}  // namespace fulcrum::ui
