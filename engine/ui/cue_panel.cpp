#include "engine/ui/cue_panel.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/ui/panels.h"
#include "engine/ui/theme.h"
#include "engine/ui/widgets.h"

namespace fulcrum::ui {
namespace {

constexpr float kWidth = 214.0F;
constexpr float kHead = 36.0F;
constexpr float kRow = 44.0F;
constexpr float kGap = 10.0F;     // to the panel above
constexpr float kBarTop = 24.0F;  // in a row
constexpr float kBarHeight = 6.0F;
constexpr float kBarReach = 5.0F;  // a press this near counts as on the bar

ImVec2 panel_at(const OverlayState& state, float width) {
  return {width - theme::kMargin - kWidth, theme::kMargin + health_height(state) + kGap};
}

void draw_row(const Canvas& canvas, ImVec2 at, const CueLine& cue) {
  const bool on = cue.gain > 0.0;
  draw_switch(canvas, at, on);
  canvas.text(canvas.fonts().body, {at.x + kSwitch.x + 10.0F, at.y - 1.0F}, on ? theme::kText : theme::kFaint,
              cue.name);
  const float right = at.x + kWidth - 2.0F * theme::kPadding;
  draw_key(canvas, {right, at.y - 2.0F}, cue.key);
  const ImVec2 bar{at.x, at.y + kBarTop};
  const float length = right - at.x;
  canvas.box(bar, {length, kBarHeight}, theme::kTrack, 3.0F);
  if (!on) return;
  const float gain = length * static_cast<float>(std::clamp(cue.gain, 0.05, 1.0));
  canvas.box(bar, {gain, kBarHeight}, (theme::kAccent & ~IM_COL32_A_MASK) | (90U << IM_COL32_A_SHIFT), 3.0F);
  const float level = length * static_cast<float>(std::clamp(cue.level, 0.0, 1.0));
  if (level > kBarHeight) canvas.box(bar, {level, kBarHeight}, theme::kWarn, 3.0F);
}

}  // namespace

float overlay_scale(std::uint32_t height) {
  const float steps = std::round(static_cast<float>(height) / 720.0F * 8.0F);
  return std::clamp(steps / 8.0F, 0.75F, 4.0F);
}

float cues_height(const OverlayState& state) {
  return state.cues.empty() ? 0.0F : kHead + static_cast<float>(state.cues.size()) * kRow + 2.0F;
}

PanelPoint panel_point(render::Extent picture, double x, double y) {
  const float unit = overlay_scale(picture.height), height = static_cast<float>(picture.height);
  return {static_cast<float>(picture.width) / unit, static_cast<float>(x) * height / unit,
          static_cast<float>(y) * height / unit};
}

void draw_cues(const Canvas& canvas, const OverlayState& state) {
  if (state.cues.empty()) return;
  const ImVec2 at = panel_at(state, canvas.width());
  canvas.card(at, {kWidth, cues_height(state)});
  canvas.disc({at.x + theme::kPadding + 4.0F, at.y + 18.0F}, 4.0F,
              state.torque_bad ? theme::kWarn : theme::kFaint);
  canvas.text(canvas.fonts().strong, {at.x + theme::kPadding + 16.0F, at.y + 9.0F}, theme::kText,
              !state.tells_torque ? state.cue_title
              : state.torque_bad  ? std::string("Bad torque")
                                  : std::string("Torque"));
  canvas.text(canvas.fonts().body, {at.x + kWidth - theme::kPadding, at.y + 9.0F}, theme::kSecondary,
              state.variant, Align::right);
  float y = at.y + kHead;
  for (const CueLine& cue : state.cues) {
    draw_row(canvas, {at.x + theme::kPadding, y}, cue);
    y += kRow;
  }
}

std::optional<CuePress> pressed_cue(const OverlayState& state, const std::vector<double>& gains, float width,
                                    float x, float y) {
  if (state.cues.empty()) return std::nullopt;
  const ImVec2 at = panel_at(state, width);
  const float left = at.x + theme::kPadding, length = kWidth - 2.0F * theme::kPadding;
  const float down = y - (at.y + kHead);
  if (x < left || x > left + length || down < -4.0F) return std::nullopt;
  const auto cue = static_cast<std::size_t>(std::max(down, 0.0F) / kRow);
  if (cue >= state.cues.size()) return std::nullopt;
  const float in_row = down - static_cast<float>(cue) * kRow;
  if (in_row > kBarTop + kBarHeight + kBarReach) return std::nullopt;
  if (in_row >= kBarTop - kBarReach)
    return CuePress{cue, std::clamp(static_cast<double>((x - left) / length), 0.05, 1.0)};
  return CuePress{cue, state.cues[cue].gain > 0.0 ? 0.0 : gains[cue]};
}

}  // namespace fulcrum::ui
