// Sentences at the bottom of the picture, each beginning a line of its own.

#include <algorithm>

#include "engine/ui/columns.h"
#include "engine/ui/panels.h"
#include "engine/ui/theme.h"

namespace fulcrum::ui {
namespace {

constexpr float kSide = 16.0F;  // between the words and the card's edge
constexpr float kLine = 18.0F;
constexpr float kLeast = 260.0F;  // narrower than this, the words go above the dials
constexpr std::size_t kMostLines = 6;

struct Words {
  std::vector<std::string> lines;
  Area area;
  bool whole = true;  // none of the message is left out
};

// Between two sides, above a bottom, in the middle of the picture where that is free.
Words between(const Canvas& canvas, const std::string& message, float left, float right, float bottom,
              std::size_t most) {
  ImFont* const font = canvas.fonts().body;
  const float room = right - left - 2.0F * kSide;
  Words words{.lines = canvas.wrapped(font, message, room), .area = {}};
  words.whole = words.lines.size() <= most;
  if (!words.whole) words.lines = canvas.lines(font, message, room, most);
  float widest = 0.0F;
  for (const std::string& line : words.lines) widest = std::max(widest, canvas.measure(font, line).x);
  const ImVec2 size{std::min(widest + 2.0F * kSide, right - left),
                    16.0F + kLine * static_cast<float>(words.lines.size())};
  const float middle = std::clamp(canvas.width() / 2.0F, left + size.x / 2.0F, right - size.x / 2.0F);
  words.area = {{middle - size.x / 2.0F, bottom - size.y}, size};
  return words;
}

Words laid_out(const Canvas& canvas, const OverlayState& state) {
  if (state.message.empty() || state.keys_visible || state.debrief) return {};
  const Columns columns = columns_of(canvas, state);
  const float margin = margin_of(canvas.height());
  const float end = canvas.width() - margin, beside_column = end - kColumn - margin;
  float bottom = canvas.height() - margin;
  if (columns.timeline.size.x > 0.0F) bottom = columns.timeline.at.y - kPanelGap;
  // Never under the panels at the right.
  const auto placed = [&](float left, std::size_t most, bool whole) {
    for (const float right : {end, beside_column}) {
      if (right - left < kLeast) continue;
      Words words = between(canvas, state.message, left, right, bottom, most);
      const Area around{{words.area.at.x, words.area.at.y - kPanelGap},
                        {words.area.size.x, words.area.size.y + kPanelGap}};
      const bool clear = std::ranges::none_of(
          std::initializer_list<Area>{columns.health, columns.cues, columns.holding, columns.motors},
          [&](const Area& area) { return touch(area, around); });
      if (clear && (words.whole || !whole)) return words;
    }
    return Words{};
  };
  const Area& dials = columns.dials;
  const bool has_dials = dials.size.x > 0.0F;
  const float foot = bottom;
  const auto beside_dials = [&](bool whole) {
    bottom = foot;
    return placed(has_dials ? dials.at.x + dials.size.x + margin : margin, kMostLines, whole);
  };
  // Where the list of checkpoints keeps a row at least.
  const auto above_dials = [&](bool whole) {
    bottom = std::min(foot, dials.at.y - kPanelGap);
    const float list = state.checkpoints.empty() ? 0.0F : checkpoints_height(state, 1) + kPanelGap;
    const float room = bottom - margin - list - 16.0F;
    if (!has_dials || room < kLine) return Words{};
    return placed(margin, std::min(kMostLines, static_cast<std::size_t>(room / kLine)), whole);
  };
  Words words;
  for (const bool whole : {true, false}) {
    if (words.lines.empty()) words = beside_dials(whole);
    if (words.lines.empty()) words = above_dials(whole);
  }
  if (!(unless_covered(canvas, state, words.area).size.x > 0.0F)) return {};
  return words;
}

}  // namespace

Area message_area(const Canvas& canvas, const OverlayState& state) {
  return laid_out(canvas, state).area;
}

void draw_message(const Canvas& canvas, const OverlayState& state) {
  const Words words = laid_out(canvas, state);
  if (words.lines.empty()) return;
  canvas.card(words.area.at, words.area.size);
  float y = words.area.at.y + 8.0F;
  for (const std::string& line : words.lines) {
    canvas.text(canvas.fonts().body, {words.area.at.x + words.area.size.x / 2.0F, y}, theme::kText, line,
                Align::centre);
    y += kLine;
  }
}

}  // namespace fulcrum::ui
