// The list of places to reach, with the trial's clock and a bar for the time to stay.

#include <algorithm>
#include <cstdio>

#include "engine/ui/columns.h"
#include "engine/ui/panels.h"
#include "engine/ui/theme.h"

namespace fulcrum::ui {
namespace {

using Show = render::MarkerState::Show;

constexpr float kWidth = 236.0F;
constexpr float kRow = 25.0F;
constexpr float kHead = 60.0F;
constexpr float kDwellRow = 18.0F;
constexpr float kFoot = 30.0F;  // the line of what is counted, the first of them
constexpr float kFaultRow = 21.0F;
constexpr float kBar = 40.0F;
constexpr double kShortOfTime = 0.1;  // of the limit, that is left

void draw_tick(const Canvas& canvas, ImVec2 middle) {
  canvas.disc(middle, 7.0F, canvas.colours().good);
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
      canvas.circle(middle, 6.0F, canvas.colours().accent, 1.8F);
      return canvas.disc(middle, 2.6F, canvas.colours().accent);
    case Show::dwelling:
      canvas.circle(middle, 6.0F, canvas.colours().warn, 1.8F);
      return canvas.disc(middle, 2.6F, canvas.colours().warn);
    case Show::hidden:
    case Show::avoid:
      return canvas.circle(middle, 6.0F, theme::kFaint, 1.2F);
  }
}

void draw_row(const Canvas& canvas, ImVec2 at, const CheckpointLine& line) {
  const Show show = line.state.show;
  const bool current = show == Show::next || show == Show::dwelling;
  const float left = at.x + theme::kPadding + 24.0F;
  const float room = at.x + kWidth - theme::kPadding - left - (show == Show::dwelling ? kBar + 8.0F : 0.0F);
  ImFont* const font = canvas.widest(
      {current ? canvas.fonts().strong : canvas.fonts().body, canvas.fonts().small}, line.name, room);
  const ImU32 colour = current ? theme::kText : show == Show::done ? theme::kSecondary : theme::kFaint;
  draw_symbol(canvas, {at.x + theme::kPadding + 7.0F, at.y + kRow / 2.0F}, show);
  const float top = at.y + (kRow - canvas.measure(font, "A").y) / 2.0F;
  canvas.text(font, {left, top}, colour, canvas.fitted(font, line.name, room));
  if (show == Show::dwelling) {
    const ImVec2 bar{at.x + kWidth - theme::kPadding - kBar, at.y + kRow / 2.0F - 3.0F};
    canvas.box(bar, {kBar, 6.0F}, theme::kTrack, 3.0F);
    canvas.box(bar, {kBar * std::clamp(line.state.progress, 0.1F, 1.0F), 6.0F}, canvas.colours().warn, 3.0F);
  }
}

void draw_faults(const Canvas& canvas, ImVec2 at, const std::vector<CountLine>& faults) {
  const float left = at.x + theme::kPadding;
  const float right = at.x + kWidth - theme::kPadding;
  canvas.box({left, at.y + 3.0F}, {right - left, 1.0F}, theme::kTrack, 0.0F);
  float y = at.y + 11.0F;
  for (const CountLine& line : faults) {
    const ImU32 colour = line.count > 0 ? canvas.colours().warn : theme::kSecondary;
    canvas.text(canvas.fonts().body, {left, y}, colour, line.name);
    canvas.text(canvas.fonts().strong, {right, y}, colour, std::to_string(line.count), Align::right);
    y += kFaultRow;
  }
}

float faults_height(const OverlayState& state) {
  return state.faults.empty() ? 0.0F : kFoot + static_cast<float>(state.faults.size() - 1) * kFaultRow;
}

float head_height(const OverlayState& state) {
  return kHead + (state.trial && state.trial->dwell_s > 0.0 ? kDwellRow : 0.0F);
}

// Below the title: how long it has taken, how many of them are done, and how long to stay at each.
void draw_head(const Canvas& canvas, ImVec2 at, const OverlayState& state) {
  const Fonts& fonts = canvas.fonts();
  const float left = at.x + theme::kPadding, right = at.x + kWidth - theme::kPadding;
  ImFont* const font = canvas.widest({fonts.strong, fonts.small}, state.scenario, right - left);
  canvas.text(font, {left, at.y + 11.0F}, theme::kText, canvas.fitted(font, state.scenario, right - left));
  const auto done = std::ranges::count(state.checkpoints, Show::done,
                                       [](const CheckpointLine& line) { return line.state.show; });
  canvas.text(fonts.body, {right, at.y + 32.0F}, theme::kSecondary,
              std::to_string(done) + " / " + std::to_string(state.checkpoints.size()), Align::right);
  if (!state.trial) return;
  const TrialTime& trial = *state.trial;
  const bool short_of_time = trial.limit_s - trial.now_s < kShortOfTime * trial.limit_s;
  char words[64];
  std::snprintf(words, sizeof words, "%.0f of %g s", trial.now_s, trial.limit_s);
  canvas.text(fonts.body, {left, at.y + 32.0F}, short_of_time ? canvas.colours().warn : theme::kSecondary,
              words);
  if (!(trial.dwell_s > 0.0)) return;
  std::snprintf(words, sizeof words, "Stay %.3g s at each", trial.dwell_s);
  canvas.text(fonts.small, {left, at.y + kHead - 6.0F}, theme::kSecondary, words);
}

// Those that there is room for, about the one that is due; what is left out is counted in the row below them.
struct Rows {
  std::size_t first = 0, end = 0;
  bool told = false;  // by such a row
};

Rows rows_of(const OverlayState& state, float room) {
  const std::size_t all = state.checkpoints.size();
  if (checkpoints_height(state, all) <= room) return {0, all, false};
  std::size_t most = 0;
  while (most < all && checkpoints_height(state, most + 1) <= room) ++most;
  if (most == 0) return {};
  const bool told = most >= 3;
  if (told) --most;
  const auto due = std::ranges::find_if(
      state.checkpoints, [](const CheckpointLine& line) { return line.state.show != Show::done; });
  const auto at = static_cast<std::size_t>(due - state.checkpoints.begin());
  const std::size_t before = most / 3;
  const std::size_t first = std::min(at > before ? at - before : 0, all - most);
  return {first, first + most, told};
}

// Down to what is below it in the same column.
Rows rows_shown(const Canvas& canvas, const OverlayState& state) {
  if (state.checkpoints.empty()) return {};
  const float margin = margin_of(canvas.height());
  float bottom = canvas.height() - margin;
  const Columns columns = columns_of(canvas, state);
  for (const Area& area : {columns.dials, columns.timeline, message_area(canvas, state)})
    if (area.size.x > 0.0F && area.at.x < margin + kWidth + kPanelGap)
      bottom = std::min(bottom, area.at.y - kPanelGap);
  return rows_of(state, bottom - margin);
}

std::size_t row_count(const Rows& rows) {
  return rows.end - rows.first + (rows.told ? 1 : 0);
}

}  // namespace

float checkpoints_height(const OverlayState& state, std::size_t rows) {
  if (state.checkpoints.empty()) return 0.0F;
  return head_height(state) + static_cast<float>(rows) * kRow + faults_height(state) + 8.0F;
}

Area checkpoints_area(const Canvas& canvas, const OverlayState& state) {
  const std::size_t rows = row_count(rows_shown(canvas, state));
  const float margin = margin_of(canvas.height());
  if (rows == 0 || canvas.width() < kWidth + 2.0F * margin) return {};
  return unless_covered(canvas, state, {{margin, margin}, {kWidth, checkpoints_height(state, rows)}});
}

void draw_checkpoints(const Canvas& canvas, const OverlayState& state) {
  const auto [at, size] = checkpoints_area(canvas, state);
  if (!(size.x > 0.0F)) return;
  canvas.card(at, size);
  draw_head(canvas, at, state);
  const Rows rows = rows_shown(canvas, state);
  float y = at.y + head_height(state);
  for (std::size_t i = rows.first; i < rows.end; ++i) {
    draw_row(canvas, {at.x, y}, state.checkpoints[i]);
    y += kRow;
  }
  if (rows.told) {
    const std::size_t more = state.checkpoints.size() - (rows.end - rows.first);
    canvas.text(canvas.fonts().small, {at.x + theme::kPadding + 24.0F, y + 5.0F}, theme::kFaint,
                "and " + std::to_string(more) + " more");
    y += kRow;
  }
  if (!state.faults.empty()) draw_faults(canvas, {at.x, y}, state.faults);
}

}  // namespace fulcrum::ui
