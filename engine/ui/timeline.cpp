#include "engine/ui/timeline.h"

#include <algorithm>

#include "engine/ui/cue_panel.h"
#include "engine/ui/panels.h"
#include "engine/ui/theme.h"

namespace fulcrum::ui {
namespace {

constexpr float kHigh = 58.0F;
constexpr float kLeastWide = 240.0F;
constexpr float kEdge = 18.0F;  // between the card's side and the bar's end
constexpr float kBarTop = 38.0F;

// Beside the dials, where they are; the motors, at the right, keep their place where there is room for both.
Area bar_card(const OverlayState& state, float width, float height) {
  const float dials = dials_width(state);
  const float left = theme::kMargin + (dials > 0.0F ? dials + theme::kMargin : 0.0F);
  const float motors = state.motors.empty() ? 0.0F : motors_width() + theme::kMargin;
  float right = width - theme::kMargin - motors;
  if (right - left < kLeastWide) right = width - theme::kMargin;
  return {{left, height - theme::kMargin - kHigh}, {std::max(right - left, kLeastWide), kHigh}};
}

ImU32 colour_of(Timeline::Mark::Kind kind) {
  switch (kind) {
    case Timeline::Mark::Kind::good:
      return theme::kGood;
    case Timeline::Mark::Kind::fair:
      return theme::kWarn;
    case Timeline::Mark::Kind::bad:
      return theme::kBad;
  }
  return theme::kWarn;
}

}  // namespace

float timeline_height(const OverlayState& state) {
  return state.timeline ? kHigh + theme::kMargin : 0.0F;
}

void draw_timeline(const Canvas& canvas, const OverlayState& state) {
  if (!state.timeline) return;
  const Timeline& timeline = *state.timeline;
  const auto [at, size] = bar_card(state, canvas.width(), canvas.height());
  const float left = at.x + kEdge, width = size.x - 2.0F * kEdge, top = at.y + kBarTop;
  const double end = std::max(timeline.end_s, 1e-9);
  const auto place = [&](double time) {
    return left + width * static_cast<float>(std::clamp(time / end, 0.0, 1.0));
  };
  canvas.card(at, size);
  canvas.text(canvas.fonts().body, {left, at.y + 10.0F}, theme::kText,
              canvas.fitted(canvas.fonts().body, timeline.caption, width));
  canvas.box({left, top}, {width, 6.0F}, theme::kTrack, 3.0F);
  if (timeline.at_s) canvas.box({left, top}, {place(*timeline.at_s) - left, 6.0F}, theme::kAccent, 3.0F);
  for (const Timeline::Mark& mark : timeline.marks)
    canvas.box({place(mark.time_s) - 1.0F, top - 3.0F}, {2.0F, 12.0F}, colour_of(mark.kind), 0.0F);
  if (timeline.at_s) canvas.disc({place(*timeline.at_s), top + 3.0F}, 7.0F, theme::kAccent);
}

std::optional<double> timeline_time(const OverlayState& state, render::Extent picture, double x, double y,
                                    bool dragged) {
  if (!state.timeline) return std::nullopt;
  const PanelPoint point = panel_point(picture, x, y);
  const float height = static_cast<float>(picture.height) / overlay_scale(picture.height);
  const auto [at, size] = bar_card(state, point.width, height);
  const bool inside = point.x >= at.x && point.x <= at.x + size.x && point.y >= at.y + 20.0F;
  if (!inside && !dragged) return std::nullopt;
  const float fraction = (point.x - at.x - kEdge) / (size.x - 2.0F * kEdge);
  return state.timeline->end_s * static_cast<double>(std::clamp(fraction, 0.0F, 1.0F));
}

}  // namespace fulcrum::ui
