// The window's gamepads.

#include <vector>

#include "engine/app/window/training_window.h"

namespace fulcrum::app {

PadPhase TrainingWindow::pad_phase() const {
  if (resting_) return PadPhase::ended;
  return shown_.force == ui::Force::stopped ? PadPhase::stopped : PadPhase::running;
}

void TrainingWindow::take_pads() {
  const std::vector<ui::PadState> pads = ui::pad_states();
  pad_is_there_ = !pads.empty();
  if (gamepad_ != nullptr) {
    if (const std::optional<PushedAxes> axes = pad_device_.read(pads))
      gamepad_->push(*axes);
    else
      gamepad_->lose();
  }
  std::uint32_t down = 0;
  for (const ui::PadState& pad : pads) down |= pad.buttons;
  for (const PadAction action : pad_actions(pad_presses_.pressed(down, seconds_now()), pad_phase()))
    act(action);
}

void TrainingWindow::act(PadAction action) {
  switch (action) {
    case PadAction::stop:
      send(Command{Command::Kind::stop});
      break;
    case PadAction::go_on:
      send(Command{Command::Kind::acknowledge});
      break;
    case PadAction::restart:
      restart();
      break;
    case PadAction::start_page:
      if (has_start_page_) leave_ = Leave::start_page;
      break;
    case PadAction::keys:
      keys_visible_ = !keys_visible_;
      break;
    case PadAction::view_before:
      if (!visual_.views.empty()) go_to_view((view_ + visual_.views.size() - 1) % visual_.views.size());
      break;
    case PadAction::view_after:
      if (!visual_.views.empty()) go_to_view((view_ + 1) % visual_.views.size());
      break;
    case PadAction::nearer:
      camera_.zoom(1);
      break;
    case PadAction::farther:
      camera_.zoom(-1);
      break;
    case PadAction::look_back:
      review_.press(Review::Key::back, *sink_, false);
      break;
    case PadAction::look_on:
      review_.press(Review::Key::on, *sink_, false);
      break;
    case PadAction::event_before:
      review_.press(Review::Key::before, *sink_, false);
      break;
    case PadAction::event_after:
      review_.press(Review::Key::after, *sink_, false);
      break;
    case PadAction::card:
      review_.press(Review::Key::card, *sink_, false);
  }
}

}  // namespace fulcrum::app
