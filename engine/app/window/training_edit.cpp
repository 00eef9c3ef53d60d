// What the window does for an author.

#include <GLFW/glfw3.h>

#include <chrono>

#include "engine/app/cli/terminal.h"
#include "engine/app/window/training_window.h"

namespace fulcrum::app {

SceneEditor::Seen TrainingWindow::seen_by_author() const {
  return {prepared_, loop_->newest().X_WT, camera_.camera(), stage_.window().pixels(), view_};
}

bool TrainingWindow::edit_key(int key) {
  if (key == GLFW_KEY_F8)
    editor_->next_item(seen_by_author());
  else if (key == GLFW_KEY_F9)
    editor_->put(seen_by_author());
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
    if (const std::optional<std::string> text = editor_->take_text()) stage_.window().copy(*text);
    return true;
  }
  if (!control_) return false;
  edits_ = true;
  const double height = stage_.window().pixels().height;
  editor_->press(seen_by_author(), cursor_x_ * height, cursor_y_ * height);
  if (const std::optional<std::string> text = editor_->take_text()) stage_.window().copy(*text);
  return true;
}

void TrainingWindow::add_edit_keys(std::vector<ui::KeyLine>& keys) {
  keys.push_back({"Ctrl + left", "look a place up, or drag a handle"});
  keys.push_back({"F8, F9", "another thing to put; put it, into the file"});
}

// A scene that has been made ready takes over once the force of this one has been let go. Where it is saved
// again before that, and not well, this one goes on.
void TrainingWindow::edit_on(LiveLoop& loop) {
  using namespace std::chrono_literals;
  Reloader& reloader = editor_->reloader();
  if (const auto now = std::chrono::steady_clock::now(); now - looked_ > 150ms) {
    looked_ = now;
    reloader.look();
  }
  if (reloader.wrong() != complained_) {
    complained_ = reloader.wrong();
    if (!complained_.empty()) complain(complained_);
  }
  if (edits_) return;
  if (!reloader.is_ready()) {
    if (releases_) releases_ = !loop.send({Command::Kind::acknowledge});
    return;
  }
  if (!releases_) releases_ = loop.send({Command::Kind::release});
  const TickRecord& newest = loop.newest();
  if (newest.stopped && newest.device_F_H_D.is_zero()) leave_ = Leave::reload;
}

}  // namespace fulcrum::app
