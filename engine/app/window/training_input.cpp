// The window's keys and mouse.

#include <GLFW/glfw3.h>

#include <algorithm>
#include <utility>

#include "engine/app/picture/holding_controls.h"
#include "engine/app/window/training_window.h"
#include "engine/ui/cue_panel.h"
#include "engine/ui/holding_panel.h"

namespace fulcrum::app {
namespace {

// What a key asks of the panel of the holding point.
std::optional<HoldingKey> holding_key(int key) {
  switch (key) {
    case GLFW_KEY_LEFT_BRACKET:
      return HoldingKey::nearer;
    case GLFW_KEY_RIGHT_BRACKET:
      return HoldingKey::farther;
    case GLFW_KEY_MINUS:
      return HoldingKey::softer;
    case GLFW_KEY_EQUAL:
      return HoldingKey::stiffer;
    case GLFW_KEY_N:
      return HoldingKey::method;
    case GLFW_KEY_H:
      return HoldingKey::measured;
    default:
      return std::nullopt;
  }
}

}  // namespace

void TrainingWindow::listen() {
  ui::WindowEvents events;
  events.key = [this](int key, int action, int modifiers) {
    shift_ = (modifiers & GLFW_MOD_SHIFT) != 0;
    control_ = (modifiers & GLFW_MOD_CONTROL) != 0;
    on_key(key, action);
  };
  events.button = [this](int button, int action, int modifiers) {
    shift_ = (modifiers & GLFW_MOD_SHIFT) != 0;
    button_ = action == GLFW_PRESS ? button : -1;
    control_ = (modifiers & GLFW_MOD_CONTROL) != 0;
    slides_ = scrubs_ = false;
    if (editor_ != nullptr && edit_button(button, action)) return;
    if (button_ == GLFW_MOUSE_BUTTON_LEFT) on_press();
    stage_.window().hold_pointer(button_ >= 0);
  };
  events.cursor = [this](double x, double y) { on_cursor(x, y); };
  events.scroll = [this](double, double steps) { on_scroll(steps); };
  stage_.window().set_events(std::move(events));
}

void TrainingWindow::on_press() {
  scrub(false);
  if (scrubs_) return;
  const std::optional<Command> pressed = cues_.press(shown_, stage_.window().pixels(), cursor_x_, cursor_y_);
  send(pressed);
  const ui::PanelPoint at = ui::panel_point(stage_.window().pixels(), shown_.look, cursor_x_, cursor_y_);
  const auto held = ui::pressed_holding(shown_, at);
  if (held) send(holding_commands(*shown_.holding, *held));
  slides_ = held && held->part == ui::HoldingPress::Part::place;
  if (pressed || held) button_ = -1;  // a press on a panel drags nothing in the scene
}

bool TrainingWindow::look_back(int key) {
  if (!ended_) return false;
  const auto pressed = [&]() -> std::optional<Review::Key> {
    switch (key) {
      case GLFW_KEY_LEFT:
        return Review::Key::back;
      case GLFW_KEY_RIGHT:
        return Review::Key::on;
      case GLFW_KEY_PAGE_UP:
        return Review::Key::before;
      case GLFW_KEY_PAGE_DOWN:
        return Review::Key::after;
      case GLFW_KEY_SPACE:
        return Review::Key::card;
      default:
        return std::nullopt;
    }
  }();
  if (pressed) review_.press(*pressed, *sink_, shift_);
  return pressed.has_value();
}

void TrainingWindow::scrub(bool dragged) {
  if (!ended_) return;
  const auto time =
      ui::timeline_time(shown_, stage_.window().pixels(), cursor_x_, cursor_y_, dragged && scrubs_);
  scrubs_ = time.has_value();
  if (time) review_.go_to(*time, *sink_);
}

void TrainingWindow::on_key(int key, int action) {
  // A modifier's own event comes with the state before it.
  if (key == GLFW_KEY_LEFT_SHIFT || key == GLFW_KEY_RIGHT_SHIFT) shift_ = action != GLFW_RELEASE;
  if (key == GLFW_KEY_LEFT_CONTROL || key == GLFW_KEY_RIGHT_CONTROL) control_ = action != GLFW_RELEASE;
  if (keys_ != nullptr) {
    const bool moves = tool_keys_.note(key, action);
    keys_->push(tool_keys_.axes(shift_));
    if (moves) return;
  }
  if (action != GLFW_RELEASE && look_back(key)) return;
  if (action != GLFW_PRESS) return;
  if (editor_ != nullptr && edit_key(key)) return;
  switch (key) {
    case GLFW_KEY_ESCAPE:
      send(Command{Command::Kind::stop});
      break;
    case GLFW_KEY_ENTER:
    case GLFW_KEY_KP_ENTER:
      send(Command{Command::Kind::acknowledge});
      break;
    case GLFW_KEY_R:
      restart();
      break;
    case GLFW_KEY_F10:
      if (has_start_page_) leave_ = Leave::start_page;
      break;
    case GLFW_KEY_C:
      circle_shown_ = !circle_shown_;
      break;
    case GLFW_KEY_F1:
      // Through its pages, where it has some, and away.
      keys_page_ = keys_visible_ && keys_page_ + 1 < stage_.overlay().keys_pages() ? keys_page_ + 1 : 0;
      keys_visible_ = keys_page_ > 0 || !keys_visible_;
      break;
    case GLFW_KEY_F2:
      guides_ = !guides_;
      break;
    case GLFW_KEY_F3:
      figures_visible_ = !figures_visible_;
      break;
    case GLFW_KEY_F4:
      sound_.toggle();
      break;
    case GLFW_KEY_F5:
      expert_shown_ = !expert_shown_;
      break;
    case GLFW_KEY_F6:
      touches_shown_ = !touches_shown_;
      break;
    case GLFW_KEY_F7:
      if (second_view_)
        second_view_.reset();
      else
        choose_second_view();
      break;
    case GLFW_KEY_HOME:
      camera_.reset();
      break;
    default:
      if (key >= GLFW_KEY_A && key <= GLFW_KEY_Z)
        send(cues_.toggle(static_cast<char>('A' + (key - GLFW_KEY_A)), shown_));
      if (const auto holding = holding_key(key); holding && shown_.holding)
        send(holding_commands(*shown_.holding, *holding));
      if (key >= GLFW_KEY_1 && key <= GLFW_KEY_9) go_to_view(static_cast<std::size_t>(key - GLFW_KEY_1));
  }
}

void TrainingWindow::go_to_view(std::size_t view) {
  if (view >= visual_.views.size()) return;
  camera_ = render::OrbitCamera(visual_.views[view].camera);
  view_ = view;
  if (second_view_) choose_second_view();
}

void TrainingWindow::send(const std::optional<Command>& command) {
  if (!command) return;
  // What was pressed while the display did not answer was pressed before anybody could see that the force is
  // off.
  if (command->kind == Command::Kind::acknowledge && is_held_up()) return;
  loop_->send(*command);
}

void TrainingWindow::send(const std::vector<Command>& commands) {
  for (const Command& command : commands) loop_->send(command);
}

Vec3 TrainingWindow::touch_W() const {
  return tool_mouse_.X_WH() * (scene_->tool.X_HT * prepared_.haptic.task.touch_point);
}

void TrainingWindow::on_cursor(double x, double y) {
  const render::Extent window = stage_.window().pixels();
  const double aspect = static_cast<double>(window.width) / std::max(window.height, 1U);
  const bool held = button_ >= 0 || slides_;
  const auto [to, by] = pointer_.move(stage_.renderer().plan().stereo, aspect, {x, y}, held);
  cursor_x_ = to.x;
  cursor_y_ = to.y;
  const double dx = by.x, dy = by.y;
  if (slides_ && shown_.holding) {
    const ui::PanelPoint at = ui::panel_point(stage_.window().pixels(), shown_.look, cursor_x_, cursor_y_);
    send(holding_commands(*shown_.holding, {ui::HoldingPress::Part::place, ui::dragged_place(shown_, at)}));
  }
  if (edits_) {
    const double height = stage_.window().pixels().height;
    editor_->drag(seen_by_author(), dx * height, dy * height);
    return;
  }
  if (scrubs_) scrub(true);
  if (button_ < 0 || scrubs_) return;
  const bool moves_tool = mouse_ != nullptr && button_ != GLFW_MOUSE_BUTTON_MIDDLE && !resting_;
  if (moves_tool && tool_rests()) return;
  if (moves_tool) {
    const input::ViewAxes view = view_axes(seen(), touch_W());
    if (button_ == GLFW_MOUSE_BUTTON_LEFT && shift_)
      tool_mouse_.push(view, dx, -dy);
    else if (button_ == GLFW_MOUSE_BUTTON_LEFT)
      tool_mouse_.slide(view, dx, dy);
    else if (shift_)
      tool_mouse_.roll(view, dx);
    else
      tool_mouse_.turn(view, dx, dy);
    mouse_->aim(tool_mouse_.X_WH());
  } else if (shift_) {
    camera_.pan(static_cast<float>(dx), static_cast<float>(dy));
  } else {
    camera_.orbit(static_cast<float>(dx), static_cast<float>(dy));
  }
}

void TrainingWindow::on_scroll(double steps) {
  if (control_ || mouse_ == nullptr || resting_) {
    camera_.zoom(static_cast<float>(steps));
    return;
  }
  if (tool_rests()) return;
  const input::ViewAxes view = view_axes(seen(), touch_W());
  tool_mouse_.reach(view, steps, shift_ ? input::Step::fine : input::Step::whole);
  mouse_->aim(tool_mouse_.X_WH());
}

}  // namespace fulcrum::app
