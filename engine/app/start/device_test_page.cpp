#include "engine/app/start/device_test_page.h"

#include <GLFW/glfw3.h>

#include <chrono>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

#include "engine/app/cli/interrupt.h"
#include "engine/app/start/device_trial.h"
#include "engine/input/pad_presses.h"

namespace fulcrum::app {
namespace {

using namespace std::chrono_literals;

constexpr auto kTestFramePause = 15ms;

// What the window hears while a device is tested.
struct Heard {
  DeviceTrial& trial;
  WindowStage& stage;
  double x = 0, y = 0;
  int button = -1;  // that is down, or -1
  bool shift = false;
  bool closed = false;

  ui::WindowEvents events() {
    ui::WindowEvents events;
    events.key = [this](int key, int action, int modifiers) {
      shift = (modifiers & GLFW_MOD_SHIFT) != 0;
      closed = closed || (key == GLFW_KEY_ESCAPE && action == GLFW_PRESS);
      trial.key(key, action, shift);
    };
    events.button = [this](int which, int action, int modifiers) {
      shift = (modifiers & GLFW_MOD_SHIFT) != 0;
      button = action == GLFW_PRESS ? which : -1;
      closed = closed ||
               (button == GLFW_MOUSE_BUTTON_LEFT &&
                ui::closes_device_panel(trial.panel(), stage.window().pixels(), stage.settings().look, x, y));
      stage.window().hold_pointer(button >= 0);
    };
    events.cursor = [this](double to_x, double to_y) {
      const double dx = to_x - std::exchange(x, to_x), dy = to_y - std::exchange(y, to_y);
      if (button >= 0) trial.drag(dx, dy, button == GLFW_MOUSE_BUTTON_LEFT, shift);
    };
    events.scroll = [this](double, double steps) { trial.wheel(steps, shift); };
    return events;
  }
};

}  // namespace

Result<std::string> test_device(WindowStage& stage, Backdrop& backdrop, ui::StartPage page,
                                const std::string& name) {
  const auto opened = DeviceTrial::open(name);
  if (!opened) return opened.error().sentence;
  DeviceTrial& trial = **opened;
  Heard heard{.trial = trial, .stage = stage};
  stage.window().set_events(heard.events());
  input::PadPresses pad(0);
  while (!heard.closed && !interrupted()) {
    const std::vector<ui::PadState> pads = ui::pad_states();
    trial.advance(seconds_now(), pads);
    page.tested = trial.panel();
    ui::OverlayState state;
    state.look = stage.settings().look;
    state.start = page;
    const Result<bool> open = stage.show(state, backdrop.frame());
    if (!open) return open.error();
    if (!*open) break;
    const std::uint32_t pressed = pad.pressed(ui::menu_buttons(pads), seconds_now());
    heard.closed = heard.closed || (pressed & ui::kPadB) != 0;
    std::this_thread::sleep_for(kTestFramePause);
  }
  stage.window().hold_pointer(false);
  stage.window().set_events({});
  return std::string();
}

}  // namespace fulcrum::app
