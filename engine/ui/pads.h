#pragma once
// The gamepads that are there, with each control where an Xbox pad has it, whatever the pad. From the main
// thread, while there is a Window, whose poll() finds out what has changed.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace fulcrum::ui {

// Buttons, as bits.
enum PadButton : std::uint32_t {
  kPadA = 1U << 0U,
  kPadB = 1U << 1U,
  kPadX = 1U << 2U,
  kPadY = 1U << 3U,
  kPadLeftBumper = 1U << 4U,
  kPadRightBumper = 1U << 5U,
  kPadBack = 1U << 6U,
  kPadStart = 1U << 7U,
  kPadUp = 1U << 8U,  // of the cross
  kPadRight = 1U << 9U,
  kPadDown = 1U << 10U,
  kPadLeft = 1U << 11U,
};

struct PadState {
  std::string guid{};                          // the same for pads of the same make
  std::uint16_t vendor = 0, product = 0;       // as USB numbers them; 0: not told
  double left_x = 0, left_y = 0;               // -1 to 1: right, up
  double right_x = 0, right_y = 0;             // the same
  double left_trigger = 0, right_trigger = 0;  // 0 to 1
  std::uint32_t buttons = 0;
};

std::vector<PadState> pad_states();

// What a menu takes: the buttons of all pads, with the left stick for the cross.
std::uint32_t menu_buttons(std::span<const PadState> pads);

// Where the controls of pads are that GLFW does not know; those that it knows stay as they are. mappings: a
// line each, as glfwUpdateGamepadMappings() takes them.
void learn_pads(std::span<const std::string> mappings);

}  // namespace fulcrum::ui
