#include "engine/app/edit/scene_editor.h"

#include <algorithm>
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

constexpr float kNearMarker = 14;  // px, from its middle: small ones are hit, too
constexpr int kTurnDecimals = 6;   // of a quaternion, about 2 um at 1 m

std::vector<double> numbers(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

std::vector<double> numbers(const glm::vec3& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

std::vector<double> numbers(const Quat& q) {
  return {q.w(), q.x(), q.y(), q.z()};
}

}  // namespace

SceneEditor::SceneEditor(std::filesystem::path file, const scenario::Scenario& shown,
                         std::filesystem::path calibration)
    : file_(std::move(file)), reloader_(file_, shown, std::move(calibration)) {}

void SceneEditor::press(const Seen& seen, double x, double y) {
  const Projection projection(seen.camera, seen.picture);
  const glm::vec2 at(x, y);
  float nearest = 1;  // of what counts as on it
  held_.reset();
  moved_ = false;
  const auto& checkpoints = seen.prepared.scenario.checkpoints;
  for (std::size_t i = 0; i < checkpoints.size(); ++i) {
    const glm::vec4 clip = projection.clip(checkpoints[i].position);
    if (!Projection::is_before(clip)) continue;
    const float radius =
        std::max(kNearMarker, projection.length(static_cast<float>(checkpoints[i].radius), clip));
    const float away = glm::length(projection.pixel(clip) - at) / radius;
    if (away > nearest) continue;
    nearest = away;
    held_ = {i, checkpoints[i].position};
  }
  if (held_) {
    item_ = held_->first;
    said_ = scenario::in_quotes(checkpoints[item_].name) + " is held: drag it.";
    return;
  }
  picked_ = pick(seen.prepared, seen.X_WT, seen.camera, seen.picture, x, y);
  if (picked_) text_ = picked_text(*picked_);
  said_ = picked_ ? *text_ + "\nIt is on the clipboard." : "Nothing is there.";
}

void SceneEditor::drag(const Seen& seen, double dx, double dy) {
  if (!held_) return;
  const input::ViewAxes view = view_axes(seen.camera, held_->second);
  held_->second += view.height / seen.picture.height * (dx * view.right_W - dy * view.up_W);
  moved_ = true;
}

void SceneEditor::release(const Seen& seen) {
  if (!held_) return;
  const auto [index, place] = *std::exchange(held_, std::nullopt);
  if (!moved_) return;
  const scenario::Checkpoint& checkpoint = seen.prepared.scenario.checkpoints[index];
  write(seen.prepared, Kind::checkpoint,
        {{"checkpoints." + std::to_string(checkpoint.written) + ".position", numbers(place)}},
        scenario::in_quotes(checkpoint.name));
}

std::vector<SceneEditor::Item> SceneEditor::items(const Prepared& prepared) {
  std::vector<Item> items;
  for (std::size_t i = 0; i < prepared.scenario.checkpoints.size(); ++i)
    items.push_back({Kind::checkpoint, i});
  items.push_back({Kind::start});
  items.push_back({Kind::grasp});
  if (!prepared.scenario.views.empty()) items.push_back({Kind::view});
  if (prepared.scenario.light) items.push_back({Kind::light});
  return items;
}

std::string SceneEditor::name_of(const Prepared& prepared, const Item& item) {
  switch (item.kind) {
    case Kind::checkpoint:
      return scenario::in_quotes(prepared.scenario.checkpoints[item.index].name) + " to the touch point";
    case Kind::start:
      return "the start to where the tool is";
    case Kind::grasp:
      return "the grasp to the place of the tool that was looked up";
    case Kind::view:
      return "the view to what is seen";
    case Kind::light:
      return "the light to the eye";
  }
  return {};
}

void SceneEditor::next_item(const Prepared& prepared) {
  item_ = (item_ + 1) % items(prepared).size();
  said_.clear();
}

void SceneEditor::put(const Seen& seen, std::size_t view) {
  const scenario::Scenario& scenario = seen.prepared.scenario;
  const std::vector<Item> all = items(seen.prepared);
  const Item item = all[std::min(item_, all.size() - 1)];
  const Pose X_WM = seen.X_WT * Pose{Quat::Identity(), -seen.prepared.models.p_MT};
  switch (item.kind) {
    case Kind::checkpoint: {
      const scenario::Checkpoint& checkpoint = scenario.checkpoints[item.index];
      const Vec3 place = seen.X_WT * seen.prepared.haptic.task.touch_point;
      return write(seen.prepared, item.kind,
                   {{"checkpoints." + std::to_string(checkpoint.written) + ".position", numbers(place)}},
                   scenario::in_quotes(checkpoint.name));
    }
    case Kind::start:
      return write(seen.prepared, item.kind,
                   {{"tool.start.position", numbers(X_WM.p)},
                    {"tool.start.orientation", numbers(X_WM.q), kTurnDecimals}},
                   "the start");
    case Kind::grasp:  // the model's pose in the handle, whose origin is to be at that place
      if (!picked_ || !picked_->on_tool) {
        said_ = "Press Control and the left button on the tool, where it is to be held; then again.";
        return;
      }
      return write(seen.prepared, item.kind,
                   {{"tool.grasp.position", numbers(-(scenario.tool.X_HM.q * picked_->p))}}, "the grasp");
    case Kind::view: {
      const std::string path = "views." + std::to_string(std::min(view, scenario.views.size() - 1));
      return write(
          seen.prepared, item.kind,
          {{path + ".eye", numbers(seen.camera.eye)}, {path + ".target", numbers(seen.camera.target)}},
          "the view");
    }
    case Kind::light: {
      std::vector<scenario::NumberChange> changes{
          {"light.direction", numbers(glm::normalize(seen.camera.target - seen.camera.eye))}};
      if (scenario.light->kind == render::KeyLight::Kind::spot)
        changes.push_back({"light.position", numbers(seen.camera.eye)});
      return write(seen.prepared, item.kind, std::move(changes), "the light");
    }
  }
}

std::string SceneEditor::why_elsewhere(const Prepared& prepared, Kind kind,
                                       const std::vector<scenario::NumberChange>& changes) {
  if (prepared.scenario.left_handed)
    return "The scene is mirrored, and its file is not: edit it with --set left_handed=false.";
  if (kind == Kind::checkpoint && prepared.scenario.variant.spread > 0)
    return "The places are those of a variant: edit them with --set variants.spread=0.";
  for (const std::string& override : prepared.scenario.overrides) {
    // A key of --set may be the end of a path, or the beginning of what lies below it.
    const std::string key = override.substr(0, override.find('='));
    for (const scenario::NumberChange& change : changes)
      if (change.path.starts_with(key) || ('.' + change.path).ends_with('.' + key))
        return "It is set by --set " + override + ", whatever the file says: edit it without that.";
  }
  return {};
}

void SceneEditor::write(const Prepared& prepared, Kind kind, std::vector<scenario::NumberChange> changes,
                        const std::string& what) {
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

std::string SceneEditor::message(const Prepared& prepared) const {
  std::string reload = reloader_.message();
  if (!reload.empty()) return reload;
  if (!said_.empty()) return said_;
  const std::vector<Item> all = items(prepared);
  return "Control + left button: look a place up, or drag a checkpoint. F8: another thing, F9: put " +
         name_of(prepared, all[std::min(item_, all.size() - 1)]) + ".";
}

}  // namespace fulcrum::app
