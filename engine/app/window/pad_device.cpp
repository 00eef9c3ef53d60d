#include "engine/app/window/pad_device.h"

#include <algorithm>
#include <chrono>

#include "drivers/gamepad/find_gamepads.h"
#include "drivers/gamepad/gamepad_axes.h"
#include "drivers/registry.h"

namespace fulcrum::app {

std::optional<PushedAxes> PadDevice::read(std::span<const ui::PadState> pads) {
  const auto found = std::ranges::find_if(pads, [&](const ui::PadState& pad) {
    return own_.empty() ? !knows_usb(pad.vendor, pad.product) : pad.guid == own_;
  });
  if (found == pads.end()) return std::nullopt;
  own_ = found->guid;
  return axes_of({.left_x = found->left_x,
                  .left_y = found->left_y,
                  .right_x = found->right_x,
                  .right_y = found->right_y,
                  .left_trigger = found->left_trigger,
                  .right_trigger = found->right_trigger,
                  .left_bumper = (found->buttons & ui::kPadLeftBumper) != 0,
                  .right_bumper = (found->buttons & ui::kPadRightBumper) != 0});
}

std::vector<std::string> gamepad_mappings() {
  std::vector<std::string> mappings;
  for (GamepadPlace& place : find_gamepads()) mappings.push_back(std::move(place.mapping));
  return mappings;
}

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace fulcrum::app
