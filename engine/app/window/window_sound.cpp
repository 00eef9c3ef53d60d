#include "engine/app/window/window_sound.h"

#include "engine/app/prepare/scene_sound.h"

namespace fulcrum::app {

void WindowSound::begin(audio::Player* player) {
  player_ = player;
  chimes_ = TaskChimes();
  set_volume();
}

void WindowSound::note(const scenario::TaskState& task) {
  if (player_ == nullptr) return;
  if (const std::optional<audio::Chime> chime = chimes_.next(task)) player_->chime(*chime);
}

void WindowSound::hear_from(const render::Camera& camera) {
  if (player_ != nullptr) player_->hear_from(listener_at(camera));
}

void WindowSound::rest() {
  if (player_ != nullptr) player_->rest();
}

void WindowSound::toggle() {
  muted_ = !muted_;
  set_volume();
}

void WindowSound::set_volume() {
  if (player_ != nullptr) player_->set_volume(muted_ ? 0 : volume_);
}

}  // namespace fulcrum::app
