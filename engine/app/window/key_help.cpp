#include "engine/app/window/key_help.h"

#include <algorithm>
#include <cctype>

#include "engine/app/picture/holding_controls.h"

namespace fulcrum::app {
namespace {

constexpr std::size_t kViewKeys = 9;

std::string lower(std::string name) {
  for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return name;
}

// The keys of the views, and which view each goes to.
ui::KeyLine view_line(std::span<const scenario::View> views) {
  const std::size_t count = std::min(views.size(), kViewKeys);
  std::string names;
  for (std::size_t i = 0; i < count; ++i)
    names.append(i == 0 ? "views: " : ", ").append(std::to_string(i + 1) + " ").append(view_name(views[i]));
  return {count == 1 ? "1" : "1 to " + std::to_string(count), names};
}

}  // namespace

std::string view_name(const scenario::View& view) {
  std::string name = view.name;
  std::ranges::replace(name, '_', ' ');
  return name;
}

std::vector<ui::KeyLine> key_lines(const ui::OverlayState& state, std::span<const scenario::View> views,
                                   bool circle, bool has_start_page) {
  std::vector<ui::KeyLine> lines;
  if (!state.timeline) lines = {{"Esc", "stop force and time"}, {"Enter", "go on; the force returns"}};
  lines.push_back({"R", "start again"});
  if (has_start_page) lines.push_back({"F10", "back to the start page"});
  if (!views.empty()) lines.push_back(view_line(views));
  lines.push_back({"Home", "back to this view's start"});
  if (circle) lines.push_back({"C", "show or hide the circle of confusion"});
  for (const ui::CueLine& cue : state.cues)
    lines.push_back({cue.key, "switch " + lower(cue.effect) + ": " + lower(cue.name)});
  if (state.holding) {
    const std::vector<ui::KeyLine> keys = holding_keys();
    lines.insert(lines.end(), keys.begin(), keys.end());
  }
  if (state.timeline) {
    lines.push_back({"Left, Right", "look back at the trial; with Shift, by a second"});
    lines.push_back({"Page Up, Down", "the event before, the event after"});
    lines.push_back({"Space", "show or hide what came of it"});
    if (state.timeline->has_expert) lines.push_back({"F5", "show or hide the expert's tool beside it"});
  }
  lines.push_back({"F1", "show or hide this list"});
  if (!state.checkpoints.empty()) lines.push_back({"F2", "show or hide the way to the next checkpoint"});
  lines.push_back({"F3", "show or hide the engineer's figures"});
  if (state.muted) lines.push_back({"F4", *state.muted ? "sound on" : "sound off"});
  lines.push_back({"F6", "show or hide where the tool is touched"});
  lines.push_back({"F7", "show or hide a second view"});
  return lines;
}

}  // namespace fulcrum::app
