#include "engine/ui/cue_panel.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/ui/columns.h"
#include "engine/ui/panels.h"
#include "engine/ui/theme.h"
#include "engine/ui/widgets.h"

namespace fulcrum::ui {
namespace {

constexpr float kHead = 36.0F;      // above the first row
constexpr float kNextHead = 28.0F;  // of an effect that follows another
constexpr float kNote = 16.0F;      // the line below the first heading
constexpr float kRow = 44.0F, kSlimRow = 26.0F;
constexpr float kBarTop = 24.0F;  // in a row
constexpr float kBarHeight = 6.0F;
constexpr float kBarReach = 5.0F;  // a press this near counts as on the bar
constexpr float kAbove = 4.0F;     // a press so little above a row counts as on its switch

bool begins_effect(const OverlayState& state, std::size_t cue) {
  return cue == 0 || state.cues[cue].effect != state.cues[cue - 1].effect;
}

// From the panel's top to the top of a cue's row; that of the one after the last is the panel's height.
float row_top(const OverlayState& state, std::size_t cue, bool slim) {
  float top =
      kHead + (state.tells_torque ? kNote : 0.0F) + static_cast<float>(cue) * (slim ? kSlimRow : kRow);
  for (std::size_t i = 1; i <= cue && i < state.cues.size(); ++i)
    if (begins_effect(state, i)) top += kNextHead;
  return top;
}

void draw_head(const Canvas& canvas, ImVec2 at, const OverlayState& state, std::size_t cue) {
  const bool tells = cue == 0 && state.tells_torque, bad = tells && state.torque_bad;
  canvas.disc({at.x + 4.0F, at.y + 9.0F}, 4.0F, bad ? canvas.colours().warn : theme::kFaint);
  const Fonts& fonts = canvas.fonts();
  const float room = kColumn - 2.0F * theme::kPadding - 16.0F;
  ImFont* const font = canvas.widest({fonts.strong, fonts.small}, state.cues[cue].effect, room);
  canvas.text(font, {at.x + 16.0F, at.y}, theme::kText, canvas.fitted(font, state.cues[cue].effect, room));
  if (!tells) return;
  std::string note = bad ? "bad torque" : "no bad torque";
  if (!state.variant.empty()) note += ", " + state.variant;
  canvas.text(canvas.fonts().small, {at.x + 16.0F, at.y + 19.0F},
              bad ? canvas.colours().warn : theme::kSecondary, note);
}

void draw_row(const Canvas& canvas, ImVec2 at, const CueLine& cue, bool slim) {
  const bool on = cue.gain > 0.0;
  draw_switch(canvas, at, on);
  canvas.text(canvas.fonts().body, {at.x + kSwitch.x + 10.0F, at.y - 1.0F}, on ? theme::kText : theme::kFaint,
              cue.name);
  const float right = at.x + kColumn - 2.0F * theme::kPadding;
  draw_key(canvas, {right, at.y - 2.0F}, cue.key);
  if (slim) return;
  const ImVec2 bar{at.x, at.y + kBarTop};
  const float length = right - at.x;
  canvas.box(bar, {length, kBarHeight}, theme::kTrack, 3.0F);
  if (!on) return;
  const float gain = length * static_cast<float>(std::clamp(cue.gain, 0.05, 1.0));
  canvas.box(bar, {gain, kBarHeight}, with_alpha(canvas.colours().accent, 90), 3.0F);
  const float level = length * static_cast<float>(std::clamp(cue.level, 0.0, 1.0));
  if (level > kBarHeight) canvas.box(bar, {level, kBarHeight}, canvas.colours().warn, 3.0F);
}

}  // namespace

float overlay_scale(std::uint32_t height, float text) {
  const float steps = std::round(static_cast<float>(height) / 720.0F * 8.0F);
  return std::clamp(steps / 8.0F, 0.75F, 4.0F) * text;
}

float cues_height(const OverlayState& state, bool slim) {
  return state.cues.empty() ? 0.0F : row_top(state, state.cues.size(), slim) + 2.0F;
}

PanelPoint panel_point(render::Extent picture, const Look& look, double x, double y) {
  const float unit = overlay_scale(picture.height, look.text), height = static_cast<float>(picture.height);
  return {static_cast<float>(picture.width) / unit, height / unit, static_cast<float>(x) * height / unit,
          static_cast<float>(y) * height / unit};
}

void draw_cues(const Canvas& canvas, const OverlayState& state) {
  const Columns columns = columns_of(canvas, state);
  const auto [at, size] = columns.cues;
  if (!(size.x > 0.0F)) return;
  canvas.card(at, size);
  const float left = at.x + theme::kPadding;
  for (std::size_t cue = 0; cue < state.cues.size(); ++cue) {
    const float top = at.y + row_top(state, cue, columns.slim_cues);
    if (begins_effect(state, cue))
      draw_head(canvas, {left, cue == 0 ? at.y + 9.0F : top - kNextHead + 1.0F}, state, cue);
    draw_row(canvas, {left, top}, state.cues[cue], columns.slim_cues);
  }
}

std::optional<CuePress> pressed_cue(const OverlayState& state, const std::vector<double>& gains,
                                    const PanelPoint& press) {
  const Columns columns = columns_of(state, press.width, press.height);
  const Area& panel = columns.cues;
  if (!(panel.size.x > 0.0F)) return std::nullopt;
  const float left = panel.at.x + theme::kPadding, length = panel.size.x - 2.0F * theme::kPadding;
  if (press.x < left || press.x > left + length) return std::nullopt;
  const auto top = [&](std::size_t cue) { return panel.at.y + row_top(state, cue, columns.slim_cues); };
  std::size_t cue = state.cues.size();
  while (cue > 0 && press.y < top(cue - 1) - kAbove) --cue;
  if (cue == 0) return std::nullopt;
  const float in_row = press.y - top(--cue);
  const bool on_bar = !columns.slim_cues && in_row >= kBarTop - kBarReach;
  if (in_row > (columns.slim_cues ? kSwitch.y + kAbove : kBarTop + kBarHeight + kBarReach))
    return std::nullopt;
  if (on_bar) return CuePress{cue, std::clamp(static_cast<double>((press.x - left) / length), 0.05, 1.0)};
  return CuePress{cue, state.cues[cue].gain > 0.0 ? 0.0 : gains[cue]};
}

}  // namespace fulcrum::ui
