#include "engine/ui/timeline.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "engine/ui/columns.h"
#include "engine/ui/cue_panel.h"
#include "engine/ui/panels.h"
#include "engine/ui/theme.h"

namespace fulcrum::ui {
namespace {

constexpr float kHigh = 58.0F;
constexpr float kSlim = 32.0F;     // without a caption
constexpr float kEdge = 18.0F;     // between the card's side and the bar's end
constexpr float kBarFoot = 20.0F;  // from the bar's top to the lower edge of the card without plots
constexpr float kPlotRow = 38.0F;
constexpr float kPlotHead = 15.0F;  // of a row: its words
constexpr double kLeastTop = 0.01;  // of any unit: what is told as 0 is drawn as 0
constexpr double kBeyond = 1.001;   // times the limit: what is held at it is not over it
constexpr float kMostHigh = 0.32F;  // of the picture, that the card takes

// As many plots as leave the scene its room; none while no moment is shown.
std::size_t plots_shown(const OverlayState& state, float height) {
  if (!state.timeline || !state.timeline->at_s) return 0;
  const float rows = std::floor((kMostHigh * height - kHigh) / kPlotRow);
  return std::min(state.timeline->plots.size(), static_cast<std::size_t>(std::max(rows, 0.0F)));
}

ImU32 colour_of(const Palette& colours, Timeline::Mark::Kind kind) {
  switch (kind) {
    case Timeline::Mark::Kind::good:
      return colours.good;
    case Timeline::Mark::Kind::fair:
      return colours.warn;
    case Timeline::Mark::Kind::bad:
      return colours.bad;
  }
  return colours.warn;
}

// A line for what was reached, a dot for what is fair, a triangle that points down for what is bad.
void draw_mark(const Canvas& canvas, ImVec2 middle, Timeline::Mark::Kind kind) {
  const ImU32 colour = colour_of(canvas.colours(), kind);
  switch (kind) {
    case Timeline::Mark::Kind::good:
      return canvas.box({middle.x - 1.0F, middle.y - 7.0F}, {2.0F, 14.0F}, colour, 0.0F);
    case Timeline::Mark::Kind::fair:
      return canvas.disc(middle, 2.5F, colour);
    case Timeline::Mark::Kind::bad:
      return canvas.triangle({middle.x - 4.0F, middle.y - 8.0F}, {middle.x + 4.0F, middle.y - 8.0F},
                             {middle.x, middle.y + 2.0F}, colour);
  }
}

std::string with_unit(double value, const std::string& unit) {
  char text[48];
  const double magnitude = std::abs(value);
  std::snprintf(text, sizeof text, magnitude < 5e-4 ? "0 " : magnitude < 100.0 ? "%.3g " : "%.0f ", value);
  return text + unit;
}

// One column for each unit of the picture: the largest value that falls into it.
void draw_curve(const Canvas& canvas, const Area& area, const Timeline::Plot& plot, double end, double top) {
  const auto columns = static_cast<std::size_t>(area.size.x);
  const double bottom = static_cast<double>(area.at.y + area.size.y);
  for (std::size_t column = 0; column < columns; ++column) {
    const double from = end * static_cast<double>(column) / static_cast<double>(columns);
    const double to = end * static_cast<double>(column + 1) / static_cast<double>(columns);
    const auto first = static_cast<std::size_t>(from / plot.interval_s);
    const auto last = std::max(first + 1, static_cast<std::size_t>(std::ceil(to / plot.interval_s)));
    double largest = 0.0;
    for (std::size_t i = first; i < std::min(last, plot.largest.size()); ++i)
      largest = std::max(largest, plot.largest[i]);
    if (!(largest > 0.0)) continue;
    const double height = std::max(1.0, static_cast<double>(area.size.y) * largest / top);
    canvas.box({area.at.x + static_cast<float>(column), static_cast<float>(bottom - height)},
               {1.0F, static_cast<float>(height)},
               plot.limit && largest > kBeyond * *plot.limit ? canvas.colours().bad : canvas.colours().accent,
               0.0F);
  }
}

// Its words, then the curve on a track, with the limit as a line and the moment marked.
void draw_plot(const Canvas& canvas, ImVec2 at, float width, const Timeline& timeline,
               const Timeline::Plot& plot) {
  const double end = std::max(timeline.end_s, 1e-9);
  const double peak = plot.largest.empty() ? 0.0 : std::ranges::max(plot.largest);
  const double top = std::max({1.05 * peak, 1.05 * plot.limit.value_or(0.0), kLeastTop});
  const Area area{{at.x, at.y + kPlotHead}, {width, kPlotRow - kPlotHead - 6.0F}};
  const auto now =
      static_cast<std::size_t>(std::max(timeline.at_s.value_or(0.0), 0.0) / std::max(plot.interval_s, 1e-9));
  const double value = plot.largest.empty() ? 0.0 : plot.largest[std::min(now, plot.largest.size() - 1)];
  std::string right = "peak " + with_unit(peak, plot.unit);
  if (plot.limit) right += ", limit " + with_unit(*plot.limit, plot.unit);
  ImFont* font = canvas.fonts().small;
  canvas.text(font, {at.x, at.y - 1.0F}, theme::kText, plot.name + " " + with_unit(value, plot.unit));
  canvas.text(font, {at.x + width, at.y - 1.0F}, theme::kSecondary, right, Align::right);
  canvas.box(area.at, area.size, theme::kTrack, 0.0F);
  if (plot.interval_s > 0.0) draw_curve(canvas, area, plot, end, top);
  if (plot.limit) {
    const float y = area.at.y + area.size.y * static_cast<float>(1.0 - *plot.limit / top);
    canvas.line({area.at.x, y}, {area.at.x + width, y}, canvas.colours().warn, 1.0F);
  }
  const float x = area.at.x + width * static_cast<float>(std::clamp(*timeline.at_s / end, 0.0, 1.0));
  canvas.line({x, area.at.y}, {x, area.at.y + area.size.y}, theme::kText, 1.5F);
}

}  // namespace

float timeline_panel_height(const OverlayState& state, float height, bool slim) {
  return slim ? kSlim : kHigh + kPlotRow * static_cast<float>(plots_shown(state, height));
}

void draw_timeline(const Canvas& canvas, const OverlayState& state) {
  const Columns columns = columns_of(canvas, state);
  const auto [at, size] = columns.timeline;
  if (!(size.x > 0.0F)) return;
  const Timeline& timeline = *state.timeline;
  const float left = at.x + kEdge, width = size.x - 2.0F * kEdge,
              top = at.y + (columns.slim_timeline ? kSlim : kHigh) - kBarFoot;
  const double end = std::max(timeline.end_s, 1e-9);
  const auto place = [&](double time) {
    return left + width * static_cast<float>(std::clamp(time / end, 0.0, 1.0));
  };
  canvas.card(at, size);
  if (!columns.slim_timeline) {
    const Fonts& fonts = canvas.fonts();
    ImFont* const font = canvas.widest({fonts.body, fonts.small}, timeline.caption, width);
    canvas.text(font, {left, at.y + 10.0F}, theme::kText, canvas.fitted(font, timeline.caption, width));
  }
  const ImU32 accent = canvas.colours().accent;
  canvas.box({left, top}, {width, 6.0F}, theme::kTrack, 3.0F);
  if (timeline.at_s) canvas.box({left, top}, {place(*timeline.at_s) - left, 6.0F}, accent, 3.0F);
  for (const Timeline::Mark& mark : timeline.marks)
    draw_mark(canvas, {place(mark.time_s), top + 3.0F}, mark.kind);
  if (timeline.at_s) canvas.disc({place(*timeline.at_s), top + 3.0F}, 7.0F, accent);
  if (columns.slim_timeline) return;
  const std::size_t plots = plots_shown(state, canvas.height());
  for (std::size_t i = 0; i < plots; ++i)
    draw_plot(canvas, {left, at.y + kHigh + kPlotRow * static_cast<float>(i)}, width, timeline,
              timeline.plots[i]);
}

std::optional<double> timeline_time(const OverlayState& state, render::Extent picture, double x, double y,
                                    bool dragged) {
  const PanelPoint point = panel_point(picture, state.look, x, y);
  const Columns columns = columns_of(state, point.width, point.height);
  const auto [at, size] = columns.timeline;
  if (!(size.x > 0.0F) || state.keys_visible) return std::nullopt;
  const float top = at.y + (columns.slim_timeline ? kSlim : kHigh) - 38.0F;
  const bool inside =
      point.x >= at.x && point.x <= at.x + size.x && point.y >= top && point.y <= at.y + size.y + kBarFoot;
  if (!inside && !dragged) return std::nullopt;
  const float fraction = (point.x - at.x - kEdge) / (size.x - 2.0F * kEdge);
  return state.timeline->end_s * static_cast<double>(std::clamp(fraction, 0.0F, 1.0F));
}

}  // namespace fulcrum::ui
