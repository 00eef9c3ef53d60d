// What the window does for an author.

#include <GLFW/glfw3.h>

#include "engine/app/cli/terminal.h"
#include "engine/app/window/training_window.h"

namespace fulcrum::app {

SceneEditor::Seen TrainingWindow::seen_by_author() const {
  return {prepared_, loop_->newest().X_WT, camera_.camera(), stage_.window().pixels()};
}

bool TrainingWindow::edit_key(int key) {
  if (key == GLFW_KEY_F8)
    editor_->next_item(prepared_);
  else if (key == GLFW_KEY_F9)
    editor_->put(seen_by_author(), view_);
  else
    return false;
  return true;
}

bool TrainingWindow::edit_button(int button, int action) {
  if (button != GLFW_MOUSE_BUTTON_LEFT) return false;
  if (action == GLFW_RELEASE) {
    if (!edits_) return false;
    edits_ = false;
    editor_->release(seen_by_author());
    return true;
  }
  if (!control_) return false;
  edits_ = true;
  const double height = stage_.window().pixels().height;
  editor_->press(seen_by_author(), cursor_x_ * height, cursor_y_ * height);
  if (const std::optional<std::string> text = editor_->take_text()) stage_.window().copy(*text);
  return true;
}

// A scene that has been made ready takes over once the force of this one has been let go.
void TrainingWindow::edit_on(LiveLoop& loop) {
  editor_->reloader().look();
  if (const std::string& wrong = editor_->reloader().wrong(); wrong != complained_) {
    complained_ = wrong;
    if (!wrong.empty()) complain(wrong);
  }
  if (!editor_->reloader().is_ready() || edits_) return;
  if (!releases_) releases_ = loop.send({Command::Kind::release});
  const TickRecord& newest = loop.newest();
  if (newest.stopped && newest.device_F_H_D.is_zero()) leave_ = Leave::reload;
}

}  // namespace fulcrum::app
