// The list of places to reach, with the trial's clock and a bar for the time to stay.

#include <algorithm>
#include <cstdio>

#include "engine/ui/panels.h"
#include "engine/ui/theme.h"

namespace fulcrum::ui {
namespace {

using Show = render::MarkerState::Show;

constexpr float kWidth = 236.0F;
constexpr float kRow = 25.0F;
constexpr float kHead = 60.0F;
constexpr float kDwellRow = 18.0F;
constexpr float kFoot = 30.0F;  // the line of what is counted
constexpr float kBar = 40.0F;
constexpr double kShortOfTime = 0.1;  // of the limit, that is left

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
  const float room = at.x + kWidth - theme::kPadding - left - (show == Show::dwelling ? kBar + 8.0F : 0.0F);
  ImFont* font = current ? canvas.fonts().strong : canvas.fonts().body;
  const ImU32 colour = current ? theme::kText : show == Show::done ? theme::kSecondary : theme::kFaint;
  draw_symbol(canvas, {at.x + theme::kPadding + 7.0F, at.y + kRow / 2.0F}, show);
  const float top = at.y + (kRow - canvas.measure(font, "A").y) / 2.0F;
  canvas.text(font, {left, top}, colour, canvas.fitted(font, line.name, room));
  if (show == Show::dwelling) {
    const ImVec2 bar{at.x + kWidth - theme::kPadding - kBar, at.y + kRow / 2.0F - 3.0F};
    canvas.box(bar, {kBar, 6.0F}, theme::kTrack, 3.0F);
    canvas.box(bar, {kBar * std::clamp(line.state.progress, 0.1F, 1.0F), 6.0F}, theme::kWarn, 3.0F);
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

float head_height(const OverlayState& state) {
  return kHead + (state.trial && state.trial->dwell_s > 0.0 ? kDwellRow : 0.0F);
}

// Below the title: how long it has taken, how many of them are done, and how long to stay at each.
void draw_head(const Canvas& canvas, ImVec2 at, const OverlayState& state) {
  const Fonts& fonts = canvas.fonts();
  const float left = at.x + theme::kPadding, right = at.x + kWidth - theme::kPadding;
  canvas.text(fonts.strong, {left, at.y + 11.0F}, theme::kText,
              canvas.fitted(fonts.strong, state.scenario, right - left));
  const auto done = std::ranges::count(state.checkpoints, Show::done,
                                       [](const CheckpointLine& line) { return line.state.show; });
  canvas.text(fonts.body, {right, at.y + 32.0F}, theme::kSecondary,
              std::to_string(done) + " / " + std::to_string(state.checkpoints.size()), Align::right);
  if (!state.trial) return;
  const TrialTime& trial = *state.trial;
  const bool short_of_time = trial.limit_s - trial.now_s < kShortOfTime * trial.limit_s;
  char words[64];
  std::snprintf(words, sizeof words, "%.0f of %g s", trial.now_s, trial.limit_s);
  canvas.text(fonts.body, {left, at.y + 32.0F}, short_of_time ? theme::kWarn : theme::kSecondary, words);
  if (!(trial.dwell_s > 0.0)) return;
  std::snprintf(words, sizeof words, "Stay %.3g s at each", trial.dwell_s);
  canvas.text(fonts.small, {left, at.y + kHead - 6.0F}, theme::kSecondary, words);
}

}  // namespace

Area checkpoints_area(const OverlayState& state) {
  if (state.checkpoints.empty()) return {};
  const auto rows = static_cast<float>(state.checkpoints.size());
  return {{theme::kMargin, theme::kMargin},
          {kWidth, head_height(state) + rows * kRow + (state.hard_touches ? kFoot : 0.0F) + 8.0F}};
}

void draw_checkpoints(const Canvas& canvas, const OverlayState& state) {
  if (state.checkpoints.empty()) return;
  const auto [at, size] = checkpoints_area(state);
  canvas.card(at, size);
  draw_head(canvas, at, state);
  float y = at.y + head_height(state);
  for (const CheckpointLine& line : state.checkpoints) {
    draw_row(canvas, {at.x, y}, line);
    y += kRow;
  }
  if (state.hard_touches) draw_hard_touches(canvas, {at.x, y}, *state.hard_touches);
}

}  // namespace fulcrum::ui
