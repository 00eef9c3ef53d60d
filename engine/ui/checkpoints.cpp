// The list of places to reach, with a bar for the time to stay.

#include <algorithm>

#include "engine/ui/panels.h"
#include "engine/ui/theme.h"

namespace fulcrum::ui {
namespace {

using Show = render::MarkerState::Show;

constexpr float kWidth = 236.0F;
constexpr float kRow = 25.0F;
constexpr float kHead = 40.0F;
constexpr float kFoot = 30.0F;  // the line of what is counted

void draw_tick(const Canvas& canvas, ImVec2 middle) {
  canvas.disc(middle, 7.0F, theme::kGood);
  canvas.line({middle.x - 3.2F, middle.y + 0.2F}, {middle.x - 0.8F, middle.y + 2.8F},
              theme::kCard | IM_COL32_A_MASK, 1.8F);
  canvas.line({middle.x - 0.8F, middle.y + 2.8F}, {middle.x + 3.4F, middle.y - 2.8F},
              theme::kCard | IM_COL32_A_MASK, 1.8F);
}

void draw_symbol(const Canvas& canvas, ImVec2 middle, Show show) {
  switch (show) {
    case Show::done:
      return draw_tick(canvas, middle);
    case Show::next:
      canvas.circle(middle, 6.0F, theme::kAccent, 1.8F);
      return canvas.disc(middle, 2.6F, theme::kAccent);
    case Show::dwelling:
      canvas.circle(middle, 6.0F, theme::kWarn, 1.8F);
      return canvas.disc(middle, 2.6F, theme::kWarn);
    case Show::hidden:
      return canvas.circle(middle, 6.0F, theme::kFaint, 1.2F);
  }
}

void draw_row(const Canvas& canvas, ImVec2 at, const CheckpointLine& line) {
  const Show show = line.state.show;
  const bool current = show == Show::next || show == Show::dwelling;
  const float left = at.x + theme::kPadding + 24.0F;
  const float room = at.x + kWidth - theme::kPadding - left - (show == Show::dwelling ? 70.0F : 0.0F);
  ImFont* font = current ? canvas.fonts().strong : canvas.fonts().body;
  const ImU32 colour = current ? theme::kText : show == Show::done ? theme::kSecondary : theme::kFaint;
  draw_symbol(canvas, {at.x + theme::kPadding + 7.0F, at.y + kRow / 2.0F}, show);
  const float top = at.y + (kRow - canvas.measure(font, "A").y) / 2.0F;
  canvas.text(font, {left, top}, colour, canvas.fitted(font, line.name, room));
  if (show == Show::dwelling) {
    const ImVec2 bar{at.x + kWidth - theme::kPadding - 62.0F, at.y + kRow / 2.0F - 3.0F};
    canvas.box(bar, {62.0F, 6.0F}, theme::kTrack, 3.0F);
    canvas.box(bar, {62.0F * std::clamp(line.state.progress, 0.1F, 1.0F), 6.0F}, theme::kWarn, 3.0F);
  }
}

void draw_hard_touches(const Canvas& canvas, ImVec2 at, std::int64_t count) {
  const ImU32 colour = count > 0 ? theme::kWarn : theme::kSecondary;
  const float left = at.x + theme::kPadding;
  const float right = at.x + kWidth - theme::kPadding;
  canvas.box({left, at.y + 3.0F}, {right - left, 1.0F}, theme::kTrack, 0.0F);
  canvas.text(canvas.fonts().body, {left, at.y + 11.0F}, colour, "Hard touches");
  canvas.text(canvas.fonts().strong, {right, at.y + 11.0F}, colour, std::to_string(count), Align::right);
}

}  // namespace

void draw_checkpoints(const Canvas& canvas, const OverlayState& state) {
  if (state.checkpoints.empty()) return;
  const ImVec2 at{theme::kMargin, theme::kMargin};
  const auto rows = static_cast<float>(state.checkpoints.size());
  const auto done = std::count_if(state.checkpoints.begin(), state.checkpoints.end(),
                                  [](const CheckpointLine& line) { return line.state.show == Show::done; });
  const float foot = state.hard_touches ? kFoot : 0.0F;
  canvas.card(at, {kWidth, kHead + rows * kRow + foot + 8.0F});
  const std::string count = std::to_string(done) + " / " + std::to_string(state.checkpoints.size());
  const float count_width = canvas.measure(canvas.fonts().body, count).x;
  const float room = kWidth - 2.0F * theme::kPadding - count_width - 10.0F;
  canvas.text(canvas.fonts().strong, {at.x + theme::kPadding, at.y + 11.0F}, theme::kText,
              canvas.fitted(canvas.fonts().strong, state.scenario, room));
  canvas.text(canvas.fonts().body, {at.x + kWidth - theme::kPadding, at.y + 11.0F}, theme::kSecondary, count,
              Align::right);
  float y = at.y + kHead;
  for (const CheckpointLine& line : state.checkpoints) {
    draw_row(canvas, {at.x, y}, line);
    y += kRow;
  }
  if (state.hard_touches) draw_hard_touches(canvas, {at.x, y}, *state.hard_touches);
}

}  // namespace fulcrum::ui
