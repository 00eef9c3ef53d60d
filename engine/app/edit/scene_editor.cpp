#include "engine/app/edit/scene_editor.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <span>
#include <system_error>
#include <utility>

#include "engine/app/picture/bridge.h"
#include "engine/app/picture/projection.h"
#include "engine/files/put_file.h"
#include "engine/files/regular_file.h"
#include "engine/scenario/text_store.h"
#include "engine/scenario/words.h"

namespace fulcrum::app {
namespace {

constexpr float kNearHandle = 12;    // px, from its middle
constexpr float kSamePlace = 0.05F;  // of how near counts as on a handle
constexpr int kTurnDecimals = 6;     // of a quaternion, about 2 um at 1 m

using HandleKind = Handle::Kind;

std::vector<double> numbers(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

std::vector<double> numbers(const glm::vec3& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

std::vector<double> numbers(const Quat& q) {
  return {q.w(), q.x(), q.y(), q.z()};
}

// What put() does with it.
std::string put_words(const Handle& handle) {
  switch (handle.kind) {
    case HandleKind::start:
      return "the start to where the tool is";
    case HandleKind::grasp:
      return "the grasp to the place of the tool that was looked up";
    case HandleKind::eye:
    case HandleKind::target:
      return scenario::in_quotes(handle.name.substr(0, handle.name.rfind(':'))) + " to what is seen";
    case HandleKind::light:
      return "the light to the eye";
    default:
      return scenario::in_quotes(handle.name) + " to the touch point";
  }
}

std::string place_words(const Vec3& p) {
  char text[96];
  std::snprintf(text, sizeof text, "[%.5f, %.5f, %.5f]", p.x(), p.y(), p.z());
  return text;
}

// Of the same thing in the file, wherever it is now and whatever has come before it.
bool is_same(const Handle& a, const Handle& b) {
  return a.kind == b.kind && a.name == b.name;
}

bool is_of_checkpoint(HandleKind kind) {
  return kind == HandleKind::checkpoint || kind == HandleKind::corner;
}

}  // namespace

SceneEditor::SceneEditor(std::filesystem::path file, const scenario::Scenario& shown,
                         std::filesystem::path calibration)
    : file_(std::move(file)), reloader_(file_, shown, std::move(calibration)) {}

void SceneEditor::press(const Seen& seen, double x, double y) {
  const Projection projection(seen.camera, seen.picture);
  pressed_ = {x, y};
  float nearest = 1;  // of what counts as on it
  held_.reset();
  moved_ = false;
  for (Handle& handle : handles_of(seen.prepared, seen.X_WT)) {
    const glm::vec4 clip = projection.clip(handle.p_W);
    if (!projection.is_before(clip)) continue;
    const float radius = std::max(kNearHandle, projection.length(static_cast<float>(handle.radius), clip));
    const float away = glm::length(projection.pixel(clip) - pressed_) / radius;
    const bool same_place = held_ && std::abs(away - nearest) < kSamePlace;
    if (same_place ? !is_preferred(handle, seen) || is_preferred(*held_, seen) : away >= nearest) continue;
    nearest = away;
    held_ = std::move(handle);
  }
  if (!held_) return look_up(seen, x, y);
  if (held_->kind != HandleKind::target) chosen_ = held_;
  said_ = scenario::in_quotes(held_->name) + " is held: drag it.";
}

bool SceneEditor::is_preferred(const Handle& handle, const Seen& seen) const {
  const bool of_view = handle.kind == HandleKind::eye || handle.kind == HandleKind::target;
  return of_view ? handle.index == seen.view : chosen_ && is_same(handle, *chosen_);
}

void SceneEditor::look_up(const Seen& seen, double x, double y) {
  picked_ = pick(seen.prepared, seen.X_WT, seen.camera, seen.picture, x, y);
  if (picked_) text_ = picked_text(*picked_);
  said_ = picked_ ? *text_ + "\nIt is on the clipboard." : "Nothing is there.";
}

void SceneEditor::drag(const Seen& seen, double dx, double dy) {
  if (!held_) return;
  const input::ViewAxes view = view_axes(seen.camera, held_->p_W);
  held_->p_W += view.height / seen.picture.height * (dx * view.right_W - dy * view.up_W);
  moved_ = true;
  said_ = scenario::in_quotes(held_->name) + " at " + place_words(held_->p_W);
}

void SceneEditor::release(const Seen& seen) {
  if (!held_) return;
  const Handle handle = *std::exchange(held_, std::nullopt);
  if (!moved_) return look_up(seen, static_cast<double>(pressed_.x), static_cast<double>(pressed_.y));
  write(seen.prepared, handle.kind, put_at(seen.prepared, seen.X_WT, handle, handle.p_W),
        scenario::in_quotes(handle.name));
}

std::vector<ui::HandleMark> SceneEditor::marks(const Seen& seen) const {
  const Projection projection(seen.camera, seen.picture);
  const Handle put = chosen(seen);
  std::vector<ui::HandleMark> marks;
  for (const Handle& handle : handles_of(seen.prepared, seen.X_WT)) {
    const bool is_held =
        held_ && held_->kind == handle.kind && held_->index == handle.index && held_->corner == handle.corner;
    const glm::vec4 clip = projection.clip(is_held ? held_->p_W : handle.p_W);
    if (projection.is_before(clip))
      marks.push_back({projection.pixel(clip), handle.name, is_held || is_same(handle, put)});
  }
  return marks;
}

std::vector<Handle> SceneEditor::items(const Seen& seen) {
  std::vector<Handle> all = handles_of(seen.prepared, seen.X_WT);
  std::erase_if(all, [](const Handle& handle) { return handle.kind == HandleKind::target; });
  return all;
}

Handle SceneEditor::chosen(const Seen& seen) const {
  const std::vector<Handle> all = items(seen);
  const auto found =
      std::ranges::find_if(all, [&](const Handle& handle) { return chosen_ && is_same(handle, *chosen_); });
  return found != all.end() ? *found : all.front();
}

void SceneEditor::next_item(const Seen& seen) {
  const std::vector<Handle> all = items(seen);
  const Handle now = chosen(seen);
  const auto at = std::ranges::find(all, now);
  chosen_ = at + 1 == all.end() ? all.front() : *(at + 1);
  said_.clear();
}

void SceneEditor::put(const Seen& seen) {
  const scenario::Scenario& scenario = seen.prepared.scenario;
  const Handle handle = chosen(seen);
  std::vector<scenario::NumberChange> changes;
  switch (handle.kind) {
    case HandleKind::start: {
      const Pose X_WM = seen.X_WT * Pose{Quat::Identity(), -seen.prepared.models.p_MT};
      changes = {{"tool.start.position", numbers(X_WM.p)},
                 {"tool.start.orientation", numbers(X_WM.q), kTurnDecimals}};
      break;
    }
    case HandleKind::grasp:
      if (!picked_ || !picked_->on_tool) {
        said_ = "Press Control and the left button on the tool, where it is to be held; then again.";
        return;
      }
      changes = {{"tool.grasp.position", numbers(-(scenario.tool.X_HM.q * picked_->p))}};
      break;
    case HandleKind::eye:
    case HandleKind::target: {
      const std::string path = "views." + std::to_string(handle.index);
      changes = {{path + ".eye", numbers(seen.camera.eye)}, {path + ".target", numbers(seen.camera.target)}};
      break;
    }
    case HandleKind::light:
      changes = {{"light.direction", numbers(glm::normalize(seen.camera.target - seen.camera.eye))}};
      if (scenario.light->kind == render::KeyLight::Kind::spot)
        changes.push_back({"light.position", numbers(seen.camera.eye)});
      break;
    default:
      changes = put_at(seen.prepared, seen.X_WT, handle, seen.X_WT * seen.prepared.haptic.task.touch_point);
  }
  write(seen.prepared, handle.kind, std::move(changes), scenario::in_quotes(handle.name));
}

std::string SceneEditor::why_elsewhere(const Prepared& prepared, HandleKind kind,
                                       const std::vector<scenario::NumberChange>& changes) {
  if (prepared.scenario.left_handed)
    return "The scene is mirrored, and its file is not: edit it with --set left_handed=false.";
  if (is_of_checkpoint(kind) && prepared.scenario.variant.spread > 0)
    return "The places are those of a variant: edit them with --set variants.spread=0.";
  for (const std::string& override : prepared.scenario.overrides) {
    // A key of --set may be any part of a path, or the beginning of what lies below it.
    const std::string key = '.' + override.substr(0, override.find('=')) + '.';
    // What kind of light it is decides what else it has.
    const bool light = kind == HandleKind::light && key.starts_with(".light.");
    for (const scenario::NumberChange& change : changes)
      if (light || ('.' + change.path + '.').find(key) != std::string::npos)
        return "It is set by --set " + override + ", whatever the file says: edit it without that.";
  }
  return {};
}

void SceneEditor::write(const Prepared& prepared, HandleKind kind,
                        std::vector<scenario::NumberChange> changes, const std::string& what) {
  if (said_ = why_elsewhere(prepared, kind, changes); !said_.empty()) return;
  const std::optional<std::string> text = text_of(prepared);
  if (!text) return;
  const auto written = scenario::written_back(*text, file_.string(), changes);
  if (!written) {
    said_ = scenario::to_text(written.faults());
    return;
  }
  // What a link points to is written, and who may read it stays.
  std::error_code fault;
  const std::filesystem::path target = std::filesystem::canonical(file_, fault);
  const std::filesystem::perms rights = std::filesystem::status(target, fault).permissions();
  if (fault || !put_file(target, {std::as_bytes(std::span(*written))})) {
    said_ = file_.string() + " cannot be written: see that its folder is yours and has room.";
    return;
  }
  std::filesystem::permissions(target, rights, fault);
  written_ = *written;
  said_ = what + " is written.";
}

std::optional<std::string> SceneEditor::text_of(const Prepared& prepared) {
  Result<std::string> text = scenario::read_text(RegularFile::open(file_));
  if (!text) {
    said_ = text.error().sentence;
    return std::nullopt;
  }
  const scenario::SourceTexts& seen = prepared.scenario.texts;
  if (*text == seen.files.at(seen.scenario) || (!written_.empty() && *text == written_))
    return std::move(*text);
  said_ =
      "The file has been saved since, and nothing was written: again, once the scene is that of the file.";
  return std::nullopt;
}

std::string SceneEditor::message(const Seen& seen) const {
  std::string reload = reloader_.message();
  if (!reload.empty()) return reload;
  if (!said_.empty()) return said_;
  return "Control + left button: look a place up, or drag a handle. F8: another one, F9: put " +
         put_words(chosen(seen)) + ".";
}

}  // namespace fulcrum::app
