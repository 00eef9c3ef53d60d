#pragma once
// A device that is tried on the start page: what it senses is shown, and nothing is asked of its motors.

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "drivers/registry.h"
#include "engine/app/window/pad_device.h"
#include "engine/app/window/tool_keys.h"
#include "engine/input/tool_mouse.h"
#include "engine/ui/device_panel.h"
#include "engine/ui/pads.h"

namespace fulcrum::app {

class DeviceTrial {
public:
  // name: as --device takes it. Errors: it cannot be had now.
  static Result<std::unique_ptr<DeviceTrial>> open(const std::string& name);
  // Of a device that is there. desc: its figures.
  DeviceTrial(std::string name, DeviceDesc desc, OpenDevice device);

  // What the window has heard. key, action: GLFW's. dx, dy: of a drag with the left button, or another, in
  // fractions of the picture's height.
  void key(int key, int action, bool shift);
  void drag(double dx, double dy, bool left, bool shift);
  void wheel(double steps, bool shift);
  // now: s, of a steady clock. The device is read as often as a run would have.
  void advance(double now, std::span<const ui::PadState> pads);

  ui::DevicePanel panel() const;

private:
  static constexpr std::size_t kAxes = 6;  // way, turn

  void read_ticks(int ticks);

  std::string name_;
  DeviceDesc desc_;
  OpenDevice device_;
  PadDevice pad_;
  ToolKeys keys_;
  input::ToolMouse mouse_;
  std::optional<double> last_;  // when it was read
  DeviceSample sample_;
  Pose X_D0_;                           // the handle at the first sample
  std::array<double, kAxes> parts_{};   // of what it reaches, -1 to 1
  std::array<double, kAxes> values_{};  // m, rad; of what is pushed, the part of a push
  std::array<bool, kAxes> moved_{};
  std::uint32_t pad_buttons_ = 0;
};

}  // namespace fulcrum::app
